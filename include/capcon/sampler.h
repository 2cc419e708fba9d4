#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "capcon/point.h"

namespace capcon::sampling {

/// What an integral's points are mapped to by areas in proportion. Only "capcon-domain" tells them apart.
enum class Domain : std::uint32_t {
  square,   ///< rectangles, triangles, environment maps, places in a pixel
  disk,     ///< by the concentric map: the cosine hemisphere, disk lights
  cylinder  ///< x goes round: azimuth and height, the sphere of directions
};

/// The samplers that capcon's renderer knows by name, to use them elsewhere. A sampler is a plain function of
/// its arguments: the same in any order, from any thread, on any machine; so sample() may be called by many
/// threads at once.
///
///     const capcon::sampling::Sampler sampler("capcon", 64);
///     for (std::uint32_t i = 0; i < sampler.count(); ++i)
///       add(sampler.sample(pixel, i));
class Sampler {
 public:
  /// Sets of `count` >= 1 points in `parts` parts of the same size (trajectory splitting). `name`: one of
  /// sampler_names(), or "file:PATH[:shift|xor|none][:sequence]" for points of your own. Points that have to
  /// be optimised (ccvt, fpo) are made here. Throws std::runtime_error, whose what() is one sentence, for an
  /// unknown name, parts that do not divide count, or missing data. Not to be called by several threads at
  /// once with different `data`.
  explicit Sampler(std::string_view name, std::uint32_t count, std::uint32_t seed = 1,
                   std::uint32_t parts = 1, const std::string& data = shipped_data());
  Sampler(Sampler&&) noexcept;
  Sampler& operator=(Sampler&&) noexcept;
  ~Sampler();

  /// Point `index` < count() of the set that belongs to `pixel` and the pair `dimension` of dimensions. Each
  /// pixel and each pair has a set of its own. Points p * count() / parts() and those that follow are part p.
  Point sample(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension = 0,
               Domain domain = Domain::square) const;
  /// The whole set.
  std::vector<Point> set(std::uint32_t pixel, std::uint32_t dimension = 0,
                         Domain domain = Domain::square) const;

  std::uint32_t count() const;
  std::uint32_t parts() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// random, jittered, sobol-xor, sobol-owen, ccvt, capcon, capcon-domain and others (docs/render.md).
std::vector<std::string> sampler_names();

/// "0.1.0"
std::string version();

}  // namespace capcon::sampling
