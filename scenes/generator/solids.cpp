#include "generator/solids.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace capcon::scenes {

Mesh box(const Vec3& low, const Vec3& high, unsigned faces) {
  Mesh mesh;
  const auto corner = [&](int x, int y, int z) {
    return Vec3(x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z);
  };
  if (faces & kWest) mesh.quad(corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0));
  if (faces & kEast) mesh.quad(corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1));
  if (faces & kSouth) mesh.quad(corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));
  if (faces & kNorth) mesh.quad(corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0));
  if (faces & kBottom) mesh.quad(corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0));
  if (faces & kTop) mesh.quad(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
  return mesh;
}

Mesh bevelled_box(const Vec3& low, const Vec3& high, double bevel) {
  // Every corner of the box becomes three points, one on each of its faces: point(corner, axis of the face).
  Mesh mesh;
  const auto point = [&](int corner, int axis) {
    Vec3 p;
    for (int k = 0; k < 3; ++k) {
      const bool upper = corner >> k & 1;
      p[k] = upper ? high[k] : low[k];
      if (k != axis) p[k] += upper ? -bevel : bevel;
    }
    return p;
  };
  const auto face_out = [&](std::vector<Vec3> polygon) {
    const Vec3 middle = 0.5 * (low + high);
    const Vec3 normal = glm::cross(polygon[1] - polygon[0], polygon[2] - polygon[0]);
    if (glm::dot(normal, polygon[0] - middle) < 0) polygon = {polygon.rbegin(), polygon.rend()};
    if (polygon.size() == 3) return mesh.triangle(polygon[0], polygon[1], polygon[2]);
    mesh.quad(polygon[0], polygon[1], polygon[2], polygon[3]);
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int b = 1 << (axis + 1) % 3, c = 1 << (axis + 2) % 3;
    for (int side = 0; side < 2; ++side) {
      const int s = side << axis;
      face_out({point(s, axis), point(s | b, axis), point(s | b | c, axis), point(s | c, axis)});
    }
    for (int k = 0; k < 4; ++k) {  // the four edges along this axis
      const int edge = (k & 1 ? b : 0) | (k & 2 ? c : 0), other = edge | 1 << axis;
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      face_out({point(edge, u), point(other, u), point(other, v), point(edge, v)});
    }
  }
  for (int corner = 0; corner < 8; ++corner) face_out({point(corner, 0), point(corner, 1), point(corner, 2)});
  return mesh;
}

Mesh paving_stone(const std::array<Vec3, 4>& top, double bottom, double bevel) {
  Mesh mesh;
  std::array<std::uint32_t, 4> upper, middle, lower;
  const Vec3 centre = 0.25 * (top[0] + top[1] + top[2] + top[3]);
  for (int k = 0; k < 4; ++k) {
    const Vec3 inward = glm::normalize(centre - top[k]) * bevel * std::sqrt(2.0);
    upper[k] = mesh.vertex(top[k] + inward);
    middle[k] = mesh.vertex(top[k] - Vec3(0, 0, bevel));
    lower[k] = mesh.vertex(Vec3(top[k].x, top[k].y, bottom));
  }
  mesh.quad(upper[0], upper[1], upper[2], upper[3]);
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    mesh.quad(middle[k], middle[next], upper[next], upper[k]);
    mesh.quad(lower[k], lower[next], middle[next], middle[k]);
  }
  return mesh;
}

Mesh disc(double radius, double z, int segments) {
  Mesh mesh;
  const std::uint32_t centre = mesh.vertex(Vec3(0, 0, z));
  for (int i = 0; i < segments; ++i) {
    const double angle = 2 * kPi * i / segments;
    mesh.vertex(Vec3(radius * std::cos(angle), radius * std::sin(angle), z));
  }
  for (int i = 0; i < segments; ++i) mesh.triangle(centre, centre + 1 + i, centre + 1 + (i + 1) % segments);
  return mesh;
}

Mesh lathe(const std::vector<Vec2>& profile, int segments, const RadiusShape& shape) {
  Mesh mesh;
  std::vector<std::uint32_t> first(profile.size());
  for (std::size_t j = 0; j < profile.size(); ++j) {
    const bool pole = profile[j].x < 1e-9;
    for (int i = 0; i < (pole ? 1 : segments); ++i) {
      const double angle = 2 * kPi * i / segments;
      const double radius = profile[j].x * (shape ? shape(angle, profile[j].y) : 1.0);
      const std::uint32_t v =
          mesh.vertex(Vec3(radius * std::cos(angle), radius * std::sin(angle), profile[j].y));
      if (i == 0) first[j] = v;
    }
  }
  const auto at = [&](std::size_t j, int i) {
    return profile[j].x < 1e-9 ? first[j] : first[j] + static_cast<std::uint32_t>(i % segments);
  };
  for (std::size_t j = 0; j + 1 < profile.size(); ++j) {
    for (int i = 0; i < segments; ++i) mesh.quad(at(j, i), at(j, i + 1), at(j + 1, i + 1), at(j + 1, i));
  }
  return mesh;
}

}  // namespace capcon::scenes
