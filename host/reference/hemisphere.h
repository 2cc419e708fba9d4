#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace capcon::reference {

/// The unit square onto the unit disk, areas in proportion: Shirley and Chiu, "A Low Distortion Map Between
/// Disk and Square", JGT 2(3), 1997.
glm::dvec2 concentric_disk(double u, double v);

/// The disk lifted to the hemisphere z >= 0: density cos(theta) / pi (Malley's method).
glm::dvec3 cosine_hemisphere(double u, double v);

/// The tangent frame of a unit normal: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1),
/// 2017.
struct Frame {
  glm::dvec3 tangent, bitangent, normal;

  explicit Frame(const glm::dvec3& n);
  glm::dvec3 to_world(const glm::dvec3& v) const { return v.x * tangent + v.y * bitangent + v.z * normal; }
  glm::dvec3 to_local(const glm::dvec3& v) const {
    return {glm::dot(v, tangent), glm::dot(v, bitangent), glm::dot(v, normal)};
  }
};

/// A vector of the frame around the unit normal `n` to world space.
glm::dvec3 around_normal(const glm::dvec3& n, const glm::dvec3& local);

}  // namespace capcon::reference
