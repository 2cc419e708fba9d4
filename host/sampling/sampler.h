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

/// What a sampler's shader side needs: an id (shaders/layout.h, kSampler...), four words of constants and one table of
/// 16-byte texels. Empty where the sampler needs none.
struct SamplerTables {
  std::uint32_t id = 0;
  std::array<std::uint32_t, 4> constants{};
  std::vector<glm::uvec4> texels;
};

/// 2D points for every (pixel, dimension pair): one set of `count` points a pair, decorrelated between pixels and
/// dimension pairs in the way that keeps the set's properties (rotation on the torus for tiles and CCVT sets; nets get
/// their own scrambling). The value of a point is addressed by (seed, pixel, index, dimension), never by call order.
/// Each sampler is one file here and one in shaders/sampling/; tests hold both to the same bits.
class Sampler {
 public:
  virtual ~Sampler() = default;
  /// Point `index` (0 <= index < count) of the set of dimension pair `dimension` of `pixel`.
  virtual FixedPoint sample(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension) const = 0;
  /// `first_only`: only dimension pair 0 will be asked for, which some samplers need less for.
  virtual SamplerTables tables(bool first_only) const = 0;
  SamplerTables tables() const { return tables(false); }

  const std::string& name() const { return name_; }
  std::uint32_t count() const { return count_; }
  std::uint32_t seed() const { return seed_; }

 protected:
  Sampler(std::string name, std::uint32_t count, std::uint32_t seed)
      : name_(std::move(name)), count_(count), seed_(seed) {}

 private:
  std::string name_;
  std::uint32_t count_;
  std::uint32_t seed_;
};

/// Names that make_sampler knows: random jittered sobol-xor sobol-owen ccvt capcon capcon-domain.
const std::vector<std::string>& sampler_names();

/// A sampler for sets of `count` points. Point generation (ccvt) happens here. InputError for an unknown name.
std::unique_ptr<Sampler> make_sampler(std::string_view name, std::uint32_t count, std::uint32_t seed);

/// The float that both sides make of a coordinate: its upper 24 bits / 2^24, in [0, 1).
inline float to_unit_float(std::uint32_t v) { return static_cast<float>(v >> 8) * 0x1p-24f; }

}  // namespace capcon
