#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "reference/bsdf.h"
#include "reference/geometry.h"
#include "reference/hemisphere.h"
#include "reference/surfaces.h"

namespace capcon::reference {

/// A point of a surface as something sees it, ready for light: docs/direct.md, "The estimate".
struct Vertex {
  SurfacePoint at;        ///< off the surface, the normal on the viewer's side
  std::uint32_t ignored;  ///< what rays that leave must not be tested against, or Ignored::kNone
  Bsdf bsdf;
  Frame frame;     ///< of the shading normal
  glm::dvec3 out;  ///< unit, to the viewer, in the frame

  /// f |w . n_s| for a unit direction w, `in` in the frame; 0 where it is not above both normals.
  glm::dvec3 reflect(const glm::dvec3& direction, const glm::dvec3& in) const;
};

/// A direction that a vertex's BSDF sampled.
struct Continuation {
  glm::dvec3 direction;  ///< unit, in the world
  double cosine;         ///< with the shading normal
  double pdf;            ///< in solid angle
  glm::dvec3 reflected;  ///< Vertex::reflect
};

/// By a point of [0, 1)^2 and the number in [0, 1) that chooses the component. None where it brings nothing.
std::optional<Continuation> continue_from(const Vertex& vertex, const glm::dvec2& point, double choice);

/// The normal of the mesh's normals, turned to the side of the geometric one, which stands in where there is
/// none.
glm::dvec3 turned_normal(const ShadingPoint& surface, const glm::dvec3& geometric);

/// `turned` where it has the unit direction `out` above it, else the geometric normal.
glm::dvec3 normal_seen_from(const glm::dvec3& out, const glm::dvec3& turned, const glm::dvec3& geometric);

/// Makes vertices of what rays meet.
class Vertices {
 public:
  /// Keeps references. InputError as read_materials.
  Vertices(const Scene& scene, const Geometry& geometry)
      : surfaces_(scene, geometry.primitives), bsdfs_(scene) {}

  /// What a viewer in the unit direction `out` sees.
  Vertex at(const Seen& seen, const glm::dvec3& out) const;
  const Surfaces& surfaces() const { return surfaces_; }
  const Bsdfs& bsdfs() const { return bsdfs_; }

 private:
  Surfaces surfaces_;
  Bsdfs bsdfs_;
};

}  // namespace capcon::reference
