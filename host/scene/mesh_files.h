#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace capcon {

/// Reads a mesh file, .ply or .obj by its extension.
TriangleMesh read_mesh_file(const std::filesystem::path& path, const ReadOptions& options);

/// The mesh files that a scene names. Each is read once, however often it is named, all in parallel at the
/// end.
class MeshFiles {
 public:
  /// The index in `meshes` that the mesh of this file will have; a new file gets an empty mesh at the end.
  /// Nothing when there is no such file.
  std::optional<std::uint32_t> add(const std::filesystem::path& path, std::vector<TriangleMesh>& meshes);

  /// Fills the meshes. Of several broken files the first one named is reported.
  void load(std::vector<TriangleMesh>& meshes, const ReadOptions& options) const;

 private:
  struct File {
    std::filesystem::path path;
    std::uint32_t mesh;
  };
  std::vector<File> files_;
  std::map<std::string, std::uint32_t> by_path_;
};

}  // namespace capcon
