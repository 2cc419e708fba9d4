#include "scene/whole_view.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "scene/transform.h"

namespace capcon {

Camera whole_view(const TriangleMesh& mesh) {
  glm::dvec3 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
  for (const glm::uvec3& triangle : mesh.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      const glm::dvec3 position(mesh.positions[triangle[corner]]);
      low = glm::min(low, position);
      high = glm::max(high, position);
    }
  }
  const glm::dvec3 centre = low + (high - low) * 0.5;
  // The cone of the shorter image axis touches a sphere about the box; a single point is seen from
  // distance 1.
  const double radius = glm::length(high - low) * 0.5;
  Camera camera;
  camera.fov_degrees = 40;
  const double half = camera.fov_degrees * 0.5 * 3.14159265358979323846 / 180;
  const double distance = radius > 0 ? 1.02 * radius / std::sin(half) : 1;
  const glm::dvec3 direction = glm::normalize(glm::dvec3(0.8, 0.6, -1));
  camera.camera_to_world = glm::inverse(look_at(centre + direction * distance, centre, {0, 1, 0}));
  return camera;
}

}  // namespace capcon
