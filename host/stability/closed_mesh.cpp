#include "stability/closed_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "base/hash.h"

namespace capcon::stability {

TriangleMesh closed_mesh(int levels, std::uint64_t seed) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  std::vector<glm::dvec3> points = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                    {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                    {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  TriangleMesh mesh;
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (glm::dvec3& p : points) p = glm::normalize(p);
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, is_new] = middles.try_emplace(std::pair(std::min(a, b), std::max(a, b)),
                                                    static_cast<std::uint32_t>(points.size()));
      if (is_new) points.push_back(glm::normalize(points[a] + points[b]));
      return at->second;
    };
    std::vector<glm::uvec3> finer;
    for (const glm::uvec3& t : mesh.triangles) {
      const std::uint32_t x = middle(t.x, t.y), y = middle(t.y, t.z), z = middle(t.z, t.x);
      for (const glm::uvec3& part :
           {glm::uvec3(t.x, x, z), glm::uvec3(t.y, y, x), glm::uvec3(t.z, z, y), glm::uvec3(x, y, z)})
        finer.push_back(part);
    }
    mesh.triangles = std::move(finer);
  }
  const double spacing = 1.05 / std::pow(2.0, levels);  // of neighbours
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto random = [&](int k) { return 2 * uniform64(seed, i, k) - 1; };
    const glm::dvec3 sideways = 0.4 * spacing * glm::dvec3(random(0), random(1), random(2));
    mesh.positions.emplace_back((points[i] + sideways) * (0.85 + 0.15 * random(3)));
  }
  return mesh;
}

}  // namespace capcon::stability
