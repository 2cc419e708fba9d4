#include "generator/normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

namespace capcon::scenes {

namespace {
struct Corner {
  std::uint32_t triangle;
  int k;
};

double angle(const Vec3& a, const Vec3& b) {
  return std::acos(std::clamp(glm::dot(glm::normalize(a), glm::normalize(b)), -1.0, 1.0));
}

/// As the file will hold it: vertices are shared where they agree to the last bit.
std::array<float, 3> rounded(const Vec3& v) {
  return {static_cast<float>(v.x) + 0.0f, static_cast<float>(v.y) + 0.0f, static_cast<float>(v.z) + 0.0f};
}
}  // namespace

void add_normals(Mesh& mesh, double crease) {
  const double least = std::cos(crease * kPi / 180);
  std::vector<Vec3> faces;
  std::vector<std::vector<Corner>> corners(mesh.positions.size());
  for (const glm::uvec3& t : mesh.triangles) {
    const Vec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y], &c = mesh.positions[t.z];
    for (int k = 0; k < 3; ++k) corners[t[k]].push_back({static_cast<std::uint32_t>(faces.size()), k});
    faces.push_back(glm::normalize(glm::cross(b - a, c - a)));
  }
  Mesh split;
  split.triangles.resize(mesh.triangles.size());
  for (std::size_t v = 0; v < corners.size(); ++v) {
    std::map<std::array<float, 3>, std::uint32_t> made;
    for (const Corner& here : corners[v]) {
      Vec3 sum(0);
      for (const Corner& other : corners[v]) {
        if (glm::dot(faces[here.triangle], faces[other.triangle]) < least) continue;
        const glm::uvec3& t = mesh.triangles[other.triangle];
        const Vec3 p = mesh.positions[v];
        sum += faces[other.triangle] *
               angle(mesh.positions[t[(other.k + 1) % 3]] - p, mesh.positions[t[(other.k + 2) % 3]] - p);
      }
      const Vec3 normal = glm::normalize(sum);
      const auto [place, fresh] =
          made.emplace(rounded(normal), static_cast<std::uint32_t>(split.positions.size()));
      if (fresh) {
        split.positions.push_back(mesh.positions[v]);
        split.normals.push_back(normal);
      }
      split.triangles[here.triangle][here.k] = place->second;
    }
  }
  mesh = std::move(split);
}

}  // namespace capcon::scenes
