#include "generator/mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

namespace capcon::scenes {

namespace {
constexpr double kSmallestArea = 1e-9;  // square metres
}

std::uint32_t Mesh::vertex(const Vec3& position) {
  positions.push_back(position);
  return static_cast<std::uint32_t>(positions.size() - 1);
}

void Mesh::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const Vec3 normal = glm::cross(positions[b] - positions[a], positions[c] - positions[a]);
  if (0.5 * glm::length(normal) < kSmallestArea) return;
  triangles.emplace_back(a, b, c);
}

void Mesh::quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  triangle(a, b, c);
  triangle(a, c, d);
}

void Mesh::triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const std::uint32_t i = vertex(a), j = vertex(b), k = vertex(c);
  triangle(i, j, k);
}

void Mesh::quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const std::uint32_t i = vertex(a), j = vertex(b), k = vertex(c), l = vertex(d);
  quad(i, j, k, l);
}

void Mesh::append(const Mesh& other, const Matrix& transform) {
  const auto base = static_cast<std::uint32_t>(positions.size());
  for (const Vec3& position : other.positions) positions.push_back(apply(transform, position));
  const bool mirrors = glm::determinant(glm::dmat3(transform)) < 0;
  for (const glm::uvec3& t : other.triangles) {
    triangles.push_back(mirrors ? glm::uvec3(base + t.x, base + t.z, base + t.y) : t + base);
  }
}

void Mesh::flip() {
  for (glm::uvec3& t : triangles) std::swap(t.y, t.z);
}

void Model::add(const std::string& material, const Mesh& mesh, const Matrix& transform) {
  for (Part& part : parts) {
    if (part.material == material) return part.mesh.append(mesh, transform);
  }
  parts.push_back({material, {}});
  parts.back().mesh.append(mesh, transform);
}

void Model::add(const Model& other, const Matrix& transform) {
  for (const Part& part : other.parts) add(part.material, part.mesh, transform);
}

Matrix translate(double x, double y, double z) {
  return translate(Vec3(x, y, z));
}
Matrix translate(const Vec3& offset) {
  return glm::translate(Matrix(1), offset);
}

namespace {
Matrix rotate(double degrees, const Vec3& axis) {
  return glm::rotate(Matrix(1), degrees * kPi / 180, axis);
}
}  // namespace

Matrix rotate_x(double degrees) {
  return rotate(degrees, Vec3(1, 0, 0));
}
Matrix rotate_y(double degrees) {
  return rotate(degrees, Vec3(0, 1, 0));
}
Matrix rotate_z(double degrees) {
  return rotate(degrees, Vec3(0, 0, 1));
}
Matrix scale(double x, double y, double z) {
  return glm::scale(Matrix(1), Vec3(x, y, z));
}
Vec3 apply(const Matrix& transform, const Vec3& point) {
  return Vec3(transform * glm::dvec4(point, 1));
}

}  // namespace capcon::scenes
