#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "shading/material.h"

namespace capcon {

/// Materials as kernels read them (shaders/shading/bsdf.glsl, texture.glsl, measured.glsl).
///
/// Five texels a material: kind (one kHas... bit, with kHasTexture), alpha, texture header's place, table's
/// place; base; specular and the fitted chance of a measured one (1 for a conductor); eta and inner
/// reflectance; k. Then four texels a texture: pixels' place, width, height, wrap; scale and offset; factor;
/// average. Then the measured tables, a texel a node.
struct MaterialData {
  std::vector<glm::uvec4> materials;
  std::vector<glm::uvec4> textures;  ///< pixels, a texel each
  std::uint32_t kinds = 0;           ///< kHas... bits of all materials
};

MaterialData pack_materials(const Scene& scene, const Materials& materials);

}  // namespace capcon
