#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "shading/light.h"

namespace capcon {

/// Lights as kernels read them (shaders/shading/lights.glsl, environment.glsl).
struct LightData {
  std::vector<glm::uvec4> lights;        ///< eight texels each, then three a triangle of mesh lights
  std::vector<glm::uvec4> environments;  ///< maps with their tables, one after the other
  std::vector<std::uint32_t> kinds;      ///< kLight... of each light
  std::uint32_t area_lights = 0;         ///< those with an area come first
  bool octahedral = false;               ///< some map is
  /// For each of Scene::shapes what DetailOptions::light_words wants.
  std::vector<std::vector<std::uint32_t>> words;

  std::uint32_t count() const { return static_cast<std::uint32_t>(kinds.size()); }
  /// A bit a kind.
  std::uint32_t kind_bits() const;
};

LightData pack_lights(const Scene& scene, const Lights& lights);

/// Appends a map: two header texels (places of rows, row guide, columns, column guides; of pixels, width,
/// height, 1 for octahedral), rows (sum; depth below the pole at the row's top edge; density of a unit of a
/// column; depth at the bottom edge), guides and columns four words a texel, pixels a texel each. Returns its
/// place.
std::uint32_t append_map(const Image& image, const EnvironmentTable& table, std::vector<glm::uvec4>& texels);

}  // namespace capcon
