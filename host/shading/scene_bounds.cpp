#include "shading/scene_bounds.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace capcon {
namespace {

struct Box {
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};

  bool is_empty() const { return !(low.x <= high.x); }
  void add(const glm::dvec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  /// The box of another one's corners under a transform.
  void add(const glm::dmat4& transform, const Box& box) {
    if (box.is_empty()) return;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 point(corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                             corner & 4 ? box.high.z : box.low.z);
      add(glm::dvec3(transform * glm::dvec4(point, 1)));
    }
  }
};

void add_shape(Box& box, const Shape& shape, const Scene& scene) {
  if (shape.kind == ShapeKind::mesh) {
    for (const glm::vec3& point : scene.meshes[shape.mesh].positions)
      box.add(glm::dvec3(shape.to_world * glm::dvec4(point, 1)));
    return;
  }
  const double z = shape.kind == ShapeKind::sphere ? shape.radius : 0;
  const glm::dvec3 middle(0, 0, shape.kind == ShapeKind::sphere ? 0 : shape.height);
  Box own;
  own.add(middle - glm::dvec3(shape.radius, shape.radius, z));
  own.add(middle + glm::dvec3(shape.radius, shape.radius, z));
  box.add(shape.to_world, own);
}

}  // namespace

BoundingSphere scene_bounds(const Scene& scene) {
  Box box;
  for (const Shape& shape : scene.shapes) add_shape(box, shape, scene);
  std::vector<Box> objects(scene.objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    for (const Shape& shape : scene.objects[i].shapes) add_shape(objects[i], shape, scene);
  }
  for (const Instance& instance : scene.instances) box.add(instance.to_world, objects[instance.object]);
  if (box.is_empty()) return {};
  return {0.5 * (box.low + box.high), 0.5 * glm::distance(box.low, box.high)};
}

}  // namespace capcon
