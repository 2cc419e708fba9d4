#pragma once

#include "scene/scene.h"

namespace capcon {

struct BoundingSphere {
  glm::dvec3 centre{0};
  double radius = 0;
};

/// The sphere about the bounding box of all visible shapes, instances included; radius 0 for an empty scene.
BoundingSphere scene_bounds(const Scene& scene);

}  // namespace capcon
