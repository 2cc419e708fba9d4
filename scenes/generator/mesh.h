#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace capcon::scenes {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Matrix = glm::dmat4;

/// Triangles under construction, in metres, z up. Seen from outside the corners go counter-clockwise in a
/// right-handed system: cross(b - a, c - a) points out of the solid.
struct Mesh {
  std::vector<Vec3> positions;
  std::vector<glm::uvec3> triangles;
  std::vector<Vec3> normals;  ///< empty, or one a position: only of finished meshes, see add_normals

  std::uint32_t vertex(const Vec3& position);
  /// Slivers of less than a square millimetre's thousandth are left out (poles of a lathe, ends of an arch).
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);
  void triangle(const Vec3& a, const Vec3& b, const Vec3& c);
  void quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
  /// Adds a copy; a mirroring transform turns the corners round so that outside stays outside.
  void append(const Mesh& other, const Matrix& transform = Matrix(1));
  /// Exchanges inside and outside.
  void flip();
};

/// One thing made of several materials.
struct Model {
  struct Part {
    std::string material;
    Mesh mesh;
  };
  std::vector<Part> parts;

  void add(const std::string& material, const Mesh& mesh, const Matrix& transform = Matrix(1));
  void add(const Model& other, const Matrix& transform = Matrix(1));
};

Matrix translate(double x, double y, double z);
Matrix translate(const Vec3& offset);
/// Turns counter-clockwise about z as seen from above.
Matrix rotate_z(double degrees);
Matrix rotate_x(double degrees);
Matrix rotate_y(double degrees);
Matrix scale(double x, double y, double z);
Vec3 apply(const Matrix& transform, const Vec3& point);

constexpr double kPi = 3.14159265358979323846;

}  // namespace capcon::scenes
