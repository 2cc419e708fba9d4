#include "scene/mesh_files.h"

#include <exception>

#include "base/file.h"
#include "base/parallel.h"
#include "scene/obj_reader.h"
#include "scene/ply_reader.h"

namespace capcon {

TriangleMesh read_mesh_file(const std::filesystem::path& path, const ReadOptions& options) {
  const std::string bytes = read_file(path);
  return path.extension() == ".obj" ? parse_obj(bytes, path.string(), options)
                                    : parse_ply(bytes, path.string(), options);
}

std::optional<std::uint32_t> MeshFiles::add(const std::filesystem::path& path,
                                            std::vector<TriangleMesh>& meshes) {
  std::error_code error;
  const std::filesystem::path canonical = std::filesystem::canonical(path, error);
  if (error || !std::filesystem::is_regular_file(canonical, error)) return std::nullopt;
  const auto [found, is_new] =
      by_path_.emplace(canonical.string(), static_cast<std::uint32_t>(meshes.size()));
  if (is_new) {
    files_.push_back({path, found->second});
    meshes.emplace_back();
  }
  return found->second;
}

void MeshFiles::load(std::vector<TriangleMesh>& meshes, const ReadOptions& options) const {
  std::vector<std::exception_ptr> errors(files_.size());
  parallel_for(files_.size(), [&](std::size_t i) {
    try {
      meshes[files_[i].mesh] = read_mesh_file(files_[i].path, options);
    } catch (...) {
      errors[i] = std::current_exception();
    }
  });
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

}  // namespace capcon
