#pragma once

#include <limits>
#include <optional>

#include "reference/tree.h"

namespace capcon::reference {

/// What a ray sees, ready for rays that leave it.
struct Seen {
  SurfacePoint at;          ///< off the surface, on the viewer's side, and the normal on that side
  std::uint32_t primitive;  ///< what was hit
  double t;                 ///< at this distance
  std::uint32_t ignored;    ///< what rays that leave must not be tested against, or Ignored::kNone
};

/// All surfaces of a scene, with the tree to trace rays through them. Keeps pointers into the scene.
struct Geometry {
  explicit Geometry(const Scene& scene);
  Geometry(const Geometry&) = delete;

  /// What a ray sees within `t_max` of what is not ignored.
  std::optional<Seen> look(const Ray& ray, const Ignored& ignored = {},
                           double t_max = std::numeric_limits<double>::infinity()) const;

  Primitives primitives;
  Tree tree;
  double offset = 0;  ///< how far off a surface rays begin
};

}  // namespace capcon::reference
