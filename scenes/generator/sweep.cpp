#include <cmath>
#include <glm/geometric.hpp>

#include "generator/solids.h"

namespace capcon::scenes {

Mesh sweep(const std::vector<Vec2>& section, bool section_closed, const std::vector<Frame>& path, Ends ends) {
  Mesh mesh;
  const auto n = static_cast<std::uint32_t>(section.size());
  const auto steps = static_cast<std::uint32_t>(path.size());
  for (const Frame& frame : path) {
    for (const Vec2& s : section) mesh.vertex(frame.origin + s.x * frame.right + s.y * frame.up);
  }
  const std::uint32_t spans = ends == Ends::closed_loop ? steps : steps - 1;
  for (std::uint32_t i = 0; i < spans; ++i) {
    const std::uint32_t here = i * n, ahead = (i + 1) % steps * n;
    for (std::uint32_t k = 0; k < (section_closed ? n : n - 1); ++k) {
      const std::uint32_t next = (k + 1) % n;
      mesh.quad(here + k, here + next, ahead + next, ahead + k);
    }
  }
  if (ends ==
      Ends::capped) {  // a fan from the section's middle: good for convex and for star-shaped sections
    for (const std::uint32_t end : {0u, steps - 1}) {
      Vec3 middle(0);
      for (std::uint32_t k = 0; k < n; ++k) middle += mesh.positions[end * n + k] / static_cast<double>(n);
      const std::uint32_t centre = mesh.vertex(middle);
      for (std::uint32_t k = 0; k < n; ++k) {
        const std::uint32_t a = end * n + k, b = end * n + (k + 1) % n;
        end == 0 ? mesh.triangle(centre, b, a) : mesh.triangle(centre, a, b);
      }
    }
  }
  return mesh;
}

Mesh moulding(const std::vector<Vec2>& section, const std::vector<Vec3>& path, bool loop) {
  std::vector<Frame> frames;
  const std::size_t n = path.size();
  const auto left = [&](std::size_t from, std::size_t to) {
    Vec3 d = path[to] - path[from];
    d.z = 0;
    d = glm::normalize(d);
    return Vec3(-d.y, d.x, 0);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const bool first = i == 0 && !loop, last = i + 1 == n && !loop;
    const Vec3 before = first ? left(0, 1) : left((i + n - 1) % n, i);
    const Vec3 after = last ? before : left(i, (i + 1) % n);
    frames.push_back({path[i], (before + after) / (1 + glm::dot(before, after)), Vec3(0, 0, 1)});
  }
  return sweep(section, false, frames, loop ? Ends::closed_loop : Ends::open);
}

Mesh tube(const std::vector<Vec3>& points, const std::vector<double>& radii, int sides, bool capped) {
  std::vector<Vec2> circle;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * kPi * i / sides;
    circle.emplace_back(std::cos(angle), std::sin(angle));
  }
  std::vector<Frame> frames;
  Vec3 right(0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 ahead = points[std::min(i + 1, points.size() - 1)] - points[i == 0 ? 0 : i - 1];
    const Vec3 direction = glm::normalize(ahead);
    if (i == 0) {
      const Vec3 helper = std::abs(direction.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
      right = glm::normalize(glm::cross(helper, direction));
    } else {  // carried along the path with as little turning as possible
      right = glm::normalize(right - direction * glm::dot(right, direction));
    }
    const Vec3 up = glm::cross(direction, right);
    frames.push_back({points[i], right * radii[i], up * radii[i]});
  }
  return sweep(circle, true, frames, capped ? Ends::capped : Ends::open);
}

}  // namespace capcon::scenes
