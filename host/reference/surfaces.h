#pragma once

#include <vector>

#include "reference/primitives.h"

namespace capcon::reference {

/// What shading needs of a point of a surface.
struct ShadingPoint {
  int material;       ///< index into Scene::materials, -1 for the default
  glm::dvec3 normal;  ///< of the mesh's normals, unit, on no particular side; 0 where there is none
  glm::dvec2 uv;
};

/// Looks up the shape's attributes: docs/direct.md, "Surfaces".
class Surfaces {
 public:
  /// Keeps references.
  Surfaces(const Scene& scene, const Primitives& primitives) : scene_(scene), primitives_(primitives) {}

  ShadingPoint at(std::uint32_t primitive, const SurfacePoint& point) const;

 private:
  const Scene& scene_;
  const Primitives& primitives_;
};

}  // namespace capcon::reference
