#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/scene.h"

namespace capcon::reference {

/// In world space `direction` has unit length, so that parameters are distances.
struct Ray {
  glm::dvec3 origin;
  glm::dvec3 direction;
  int axis;          ///< the largest component of the direction
  glm::dvec2 shear;  ///< the next two components (cyclically), divided by it

  Ray(const glm::dvec3& o, const glm::dvec3& d);
  /// A point relative to the origin, seen along the ray: its two coordinates across it.
  glm::dvec2 across(const glm::dvec3& from_origin) const {
    const double along = from_origin[axis];
    return {from_origin[(axis + 1) % 3] - shear.x * along, from_origin[(axis + 2) % 3] - shear.y * along};
  }
};

struct Box {
  glm::dvec3 low{1e300};
  glm::dvec3 high{-1e300};
  void grow(const Box& other);
};

/// A point of a surface, exact to a few ulps of its primitive's coordinates however far the ray came, and the
/// unit geometric normal there.
struct SurfacePoint {
  glm::dvec3 position;
  glm::dvec3 normal;
  glm::dvec3 weights{0};  ///< barycentric, of a triangle's vertices; 0 for spheres and disks
};

/// A shape where it stands in the world. Its primitives are numbered from `first` on.
struct Placement {
  const Shape* shape;
  const Instance* instance;  ///< nullptr: one of Scene::shapes
  std::uint32_t first;
};

/// Everything of a scene that a ray can hit, in world space: objects are copied out for each of their
/// instances. Triangles come first in the numbering, then spheres and disks. Keeps pointers into the scene.
class Primitives {
 public:
  explicit Primitives(const Scene& scene);

  std::uint32_t size() const { return static_cast<std::uint32_t>(triangles_.size() + round_.size()); }
  Box bounds(std::uint32_t primitive) const;
  /// Distance of the first hit in (0, t_max], or a negative number when there is none. Edges belong to the
  /// surface.
  double intersect(std::uint32_t primitive, const Ray& ray, double t_max) const;
  /// The surface at the hit that intersect() found.
  SurfacePoint surface(std::uint32_t primitive, const Ray& ray, double t) const;
  /// A flat primitive cannot occlude its own points.
  bool flat(std::uint32_t primitive) const;
  /// The shape that it is a part of, and its number there: `primitive` - first.
  const Placement& placement(std::uint32_t primitive) const;
  /// Every placed mesh, by first primitive; every sphere and disk, one a primitive.
  const std::vector<Placement>& meshes() const { return mesh_placements_; }
  const std::vector<Placement>& rounds() const { return round_placements_; }

 private:
  struct Triangle {
    glm::dvec3 p[3];
  };
  struct Round {
    ShapeKind kind;
    double radius;
    double inner_radius;
    double height;
    glm::dmat4 to_world;
    glm::dmat4 to_object;
  };
  void add(const Scene& scene, const Shape& shape, const Instance* instance);

  /// Vertices are rounded to float once where the device side does the same with world coordinates, so that
  /// both trace the same triangles; a scene far from the origin is not, for there its floats would be coarse.
  bool rounded_;

  std::vector<Triangle> triangles_;
  std::vector<Round> round_;
  std::vector<Placement> mesh_placements_;
  std::vector<Placement> round_placements_;
};

}  // namespace capcon::reference
