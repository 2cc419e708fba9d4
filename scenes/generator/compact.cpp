#include "generator/compact.h"

#include <array>
#include <glm/geometric.hpp>
#include <map>

namespace capcon::scenes {

void compact(Mesh& mesh) {
  constexpr double kSmallestArea = 1e-10;  // square metres, after rounding to float
  std::map<std::array<float, 3>, std::uint32_t> seen;
  Mesh kept;
  const auto vertex = [&](std::uint32_t i) {
    const Vec3& p = mesh.positions[i];
    const std::array<float, 3> key{static_cast<float>(p.x) + 0.0f, static_cast<float>(p.y) + 0.0f,
                                   static_cast<float>(p.z) + 0.0f};
    const auto [place, fresh] = seen.emplace(key, static_cast<std::uint32_t>(kept.positions.size()));
    if (fresh) kept.positions.emplace_back(key[0], key[1], key[2]);
    return place->second;
  };
  for (const glm::uvec3& t : mesh.triangles) {
    const auto rounded = [&](std::uint32_t i) { return Vec3(glm::vec3(mesh.positions[i])); };
    const Vec3 a = rounded(t.x), b = rounded(t.y), c = rounded(t.z);
    if (0.5 * glm::length(glm::cross(b - a, c - a)) < kSmallestArea) continue;
    const std::uint32_t i = vertex(t.x), j = vertex(t.y), k = vertex(t.z);
    kept.triangles.emplace_back(i, j, k);
  }
  mesh = std::move(kept);
}

}  // namespace capcon::scenes
