#pragma once

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tiling/tile_set.h"

namespace capcon {

/// What a sampler's shader side needs: an id (shaders/layout.h, kSampler...), four words of constants (the
/// third is free) and one table of 16-byte texels. Empty where the sampler needs none.
struct SamplerTables {
  std::uint32_t id = 0;
  std::array<std::uint32_t, 4> constants{};
  std::vector<glm::uvec4> texels;
};

/// The domain that an integral's points are mapped to by areas in proportion. Only samplers that live in one
/// (capcon-domain) tell them apart; the numbers are those of shaders/layout.h, kDomain...
enum class SampleDomain : std::uint32_t {
  square = 0,   ///< rectangles, triangles, environment maps, places in a pixel
  disk = 1,     ///< by the concentric map: the cosine hemisphere, disk lights, cones of directions
  cylinder = 2  ///< x goes round, y does not: azimuth and height, the sphere of directions
};

/// How a pixel's points are shared out (trajectory splitting): `parts` sets of `points`, each well spread,
/// and so is their union. Points p * points ... (p + 1) * points - 1 are part p.
struct Split {
  std::uint32_t parts = 1;
  std::uint32_t points = 1;
  std::uint32_t part_stride = 1;   ///< coprime to parts, for the order of parts
  std::uint32_t point_stride = 1;  ///< coprime to points, for the order within a part
};

/// 2D points for every (pixel, dimension pair): one set of `count` points a pair, decorrelated between pixels
/// and dimension pairs in the way that keeps the set's properties (rotation on the torus for tiles and CCVT
/// sets; nets get their own scrambling). The value of a point is addressed by (seed, pixel, index,
/// dimension), never by call order. Each sampler is one file here and one in shaders/sampling/; tests hold
/// both to the same bits.
class Sampler {
 public:
  virtual ~Sampler() = default;
  /// Point `index` (0 <= index < count) of the set of dimension pair `dimension` of `pixel`. Parts and the
  /// points within each come in an order of their own in every pair but pair 0, so that pairs are not
  /// correlated.
  FixedPoint sample(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension,
                    SampleDomain domain = SampleDomain::square) const {
    return point(pixel, dimension == 0 ? index : shuffled(pixel, index, dimension), dimension, domain);
  }
  /// `domains`: those that points will be asked for in, which capcon-domain needs tables for.
  virtual SamplerTables tables(const std::vector<SampleDomain>& domains) const = 0;
  SamplerTables tables() const {
    return tables({SampleDomain::square, SampleDomain::disk, SampleDomain::cylinder});
  }

  const std::string& name() const { return name_; }
  std::uint32_t count() const { return split_.parts * split_.points; }
  const Split& split() const { return split_; }
  std::uint32_t seed() const { return seed_; }

 protected:
  /// `parts` divides `count`.
  Sampler(std::string name, std::uint32_t count, std::uint32_t seed, std::uint32_t parts = 1);
  /// The point at place `index` of the set's own order.
  virtual FixedPoint point(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension,
                           SampleDomain domain) const = 0;

  /// The place in the set's own order (or of a part of one point) that sample `index` of `count` has in a
  /// pair that is not pair 0: nested (shuffle_index), so that blocks of samples are blocks of a sequence in
  /// all pairs; any (permute), where the set is stored by place and a block would be one region in all pairs:
  /// what two pairs err together was up to 16 times that of padded nets, for jittered points.
  virtual std::uint32_t place_in_order(std::uint32_t index, std::uint32_t count, std::uint32_t stride,
                                       std::uint32_t dimension, std::uint32_t key) const;
  virtual bool is_stored_by_place() const { return false; }

 private:
  std::uint32_t shuffled(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension) const;

  std::string name_;
  Split split_;
  std::uint32_t seed_;
};

/// Names that make_sampler knows for any number of points: random jittered sobol-xor sobol-owen ccvt capcon
/// capcon-domain capcon-ranked fpo halton lattice pmj02 sobol-z. It knows capcon-screen and capcon-bounded
/// too, which are for some numbers only.
const std::vector<std::string>& sampler_names();

/// Those that studies of ambient occlusion and of direct lighting compare unless told otherwise: all but fpo,
/// halton, lattice and pmj02, which are there for comparison with the literature.
const std::vector<std::string>& default_study_samplers();

/// A sampler for sets of `count` points in `parts` parts of the same size. `width`: of the image, in pixels,
/// which `pixel` numbers row by row, for samplers that know neighbours (capcon-screen, sobol-z); 0: one row.
/// Point generation (ccvt, fpo) happens here. InputError for an unknown name, and where parts do not divide
/// count.
std::unique_ptr<Sampler> make_sampler(std::string_view name, std::uint32_t count, std::uint32_t seed,
                                      std::uint32_t parts = 1, int width = 0);

/// The float that both sides make of a coordinate: its upper 24 bits / 2^24, in [0, 1).
inline float to_unit_float(std::uint32_t v) {
  return static_cast<float>(v >> 8) * 0x1p-24f;
}

}  // namespace capcon
