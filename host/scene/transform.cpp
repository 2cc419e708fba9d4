#include "scene/transform.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace capcon {

glm::dmat4 rotation(double degrees, const glm::dvec3& axis) {
  // Rodrigues' formula, column by column. Quarter turns are exact: exporters write them all the time.
  const glm::dvec3 a = glm::normalize(axis);
  const double turns = degrees / 90;
  const bool quarter = turns == std::floor(turns);
  const double radians = degrees * (3.14159265358979323846 / 180);
  const int step = quarter ? static_cast<int>(std::fmod(std::fmod(turns, 4) + 4, 4)) : 0;
  const double sines[] = {0, 1, 0, -1};
  const double sine = quarter ? sines[step] : std::sin(radians);
  const double cosine = quarter ? sines[(step + 1) % 4] : std::cos(radians);
  glm::dmat4 m(1);
  for (int column = 0; column < 3; ++column) {
    glm::dvec3 e(0);
    e[column] = 1;
    m[column] = glm::dvec4(cosine * e + (1 - cosine) * a[column] * a + sine * glm::cross(a, e), 0);
  }
  return m;
}

glm::dmat4 look_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up) {
  const glm::dvec3 forward = glm::normalize(target - eye);
  const glm::dvec3 right = glm::normalize(glm::cross(glm::normalize(up), forward));
  const glm::dvec3 camera_up = glm::cross(forward, right);
  // The rows of an orthonormal frame are the columns of its inverse.
  const glm::dmat3 rows = glm::transpose(glm::dmat3(right, camera_up, forward));
  glm::dmat4 world_to_camera(rows);
  world_to_camera[3] = glm::dvec4(-(rows * eye), 1);
  return world_to_camera;
}

bool is_singular(const glm::dmat4& transform) {
  glm::dmat3 axes(transform);
  for (int column = 0; column < 3; ++column) {
    const double length = glm::length(axes[column]);
    if (!(length > 0) || !std::isfinite(length)) return true;
    axes[column] /= length;
    if (!std::isfinite(transform[3][column])) return true;
  }
  return !(std::abs(glm::determinant(axes)) > 1e-12);
}

bool is_affine(const glm::dmat4& transform) {
  for (int column = 0; column < 4; ++column) {
    if (!(std::abs(transform[column][3] - (column == 3)) <= 1e-6)) return false;
  }
  return true;
}

}  // namespace capcon
