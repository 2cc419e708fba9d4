#pragma once

#include <functional>
#include <span>

#include "render/renderer_state.h"

namespace capcon {

/// Surfaces that compensation rays met, on the host: what each needs to be lit as pixels are, and what its
/// light is worth to its pixel. In the order of the pixel's place in its block, then of their rays.
struct Receivers {
  struct Weight {
    glm::dvec3 scale;     ///< what the light of the surface is multiplied by
    std::uint32_t pixel;  ///< of the image
  };
  std::vector<glm::uvec4> surfaces;  ///< three texels each
  std::vector<glm::uvec4> shading;   ///< two texels each
  std::vector<Weight> weights;
  std::vector<std::uint32_t> first = {0};  ///< of those of each place in a block, and the end

  std::uint32_t count() const { return static_cast<std::uint32_t>(weights.size()); }
};

/// Those of the rays that found something (six texels each, shaders/compensation.comp). `place(pixel)`: a
/// pixel's place in its block, below `places`. `before`: the surfaces that the rays came from; none: pixels.
Receivers pick_receivers(std::span<const glm::uvec4> found, std::uint32_t places,
                         const std::function<std::uint32_t(std::uint32_t pixel)>& place,
                         const Receivers* before);

}  // namespace capcon
