#pragma once

#include <filesystem>
#include <map>

#include "generator/mesh.h"

namespace capcon::scenes {

/// A scene as models and the places where they stand; a model that stands in several places is written once,
/// as an object.
class Assembly {
 public:
  explicit Assembly(std::string name) : name_(std::move(name)) {}

  /// Puts a new model here; the name is new in this scene and fit for a file name.
  /// With a crease in degrees its meshes get normals: edges that bend less look smooth.
  void define(const std::string& name, Model model, double crease = 0);
  /// Lets a defined model stand somewhere.
  void place(const std::string& name, const Matrix& where = Matrix(1));
  /// define and place in one: something that exists once.
  void add(const std::string& name, Model model, const Matrix& where = Matrix(1), double crease = 0);
  /// Repeats all that has been placed so far: nx times along x and ny times along y, `step` metres apart.
  void repeat(int nx, int ny, const Vec2& step);

  const std::string& name() const { return name_; }
  std::uint64_t unique_triangles() const;
  std::uint64_t instanced_triangles() const;

  /// Writes <folder>/<scene>-<model>-<material>.ply for every part, and <folder>/<scene>-shapes.pbrt, which
  /// names them relative to the folder above, by materials that the scene file declares (MakeNamedMaterial).
  void write(const std::filesystem::path& folder) const;

  struct Entry {
    Model model;
    std::vector<Matrix> places;
  };
  const std::map<std::string, Entry>& entries() const { return entries_; }

 private:
  std::string shapes_text() const;
  std::string part_file(const std::string& model, const std::string& material) const;

  std::string name_;
  std::map<std::string, Entry> entries_;
};

}  // namespace capcon::scenes
