#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/scene.h"

namespace capcon {

/// A virtual point light (VPL): a hit of a light path on a surface (Keller, "Instant Radiosity", 1997). World
/// space; docs/igi.md has its use.
struct VirtualLight {
  glm::dvec3 position{0};        ///< off the surface, on the side that the path came from
  glm::dvec3 normal{0};          ///< geometric, unit, on that side
  glm::dvec3 shading_normal{0};  ///< unit, turned to that side
  glm::dvec3 arriving{0};        ///< unit, to where the path came from
  glm::dvec3 flux{0};            ///< that arrives, W; already divided by the number of paths of its set
  glm::dvec2 uv{0};
  int material = -1;            ///< index into Scene::materials, -1 for the default
  std::uint32_t primitive = 0;  ///< in the numbering of whoever traced the path
  std::uint32_t path = 0;       ///< of its set
  std::uint32_t bounce = 1;     ///< 1: where the path first hit
};

/// The VPLs of a render: set by set, in each by bounce, then by path.
struct VirtualLights {
  std::vector<VirtualLight> lights;
  std::vector<std::uint32_t> first = {0};  ///< of each set, and the end
  std::uint32_t sets() const { return static_cast<std::uint32_t>(first.size()) - 1; }
};

/// The limit of the geometry term for renders that were told none: that of two surfaces that face each other
/// at 0.04 of the diagonal of the scene's bounding box.
double default_geometry_limit(const Scene& scene);

/// Shares of 0.32 fixed point by which paths choose lights: thresholds[j] is where light j's part of [0, 1)
/// ends, in proportion to the luminance of Light::power; the last is 2^32 - 1 and stands for 1. Every light
/// of some power has at least one unit.
std::vector<std::uint32_t> power_thresholds(const std::vector<glm::dvec3>& powers);

}  // namespace capcon
