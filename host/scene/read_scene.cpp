#include <filesystem>

#include "base/file.h"
#include "scene/mesh_files.h"
#include "scene/pbrt_reader.h"
#include "scene/scene.h"
#include "scene/scene_notes.h"
#include "scene/whole_view.h"

namespace capcon {
namespace {

std::uint64_t triangles(const Scene& scene, const std::vector<Shape>& shapes) {
  std::uint64_t count = 0;
  for (const Shape& shape : shapes) {
    if (shape.kind == ShapeKind::mesh) count += scene.meshes[shape.mesh].triangles.size();
  }
  return count;
}

Scene read_bare_mesh(const std::filesystem::path& path, const ReadOptions& options) {
  Scene scene;
  scene.name = path.stem().string();
  scene.meshes.push_back(read_mesh_file(path, options));
  if (scene.meshes[0].triangles.empty()) throw InputError(path.string() + ": this mesh has no triangles");
  Shape shape;
  shape.place = {path.string()};
  scene.shapes.push_back(std::move(shape));
  scene.camera = whole_view(scene.meshes[0]);
  return scene;
}

}  // namespace

std::uint64_t Scene::unique_triangles() const {
  std::uint64_t count = triangles(*this, shapes) + triangles(*this, hidden_shapes);
  for (const Object& object : objects) count += triangles(*this, object.shapes);
  return count;
}

std::uint64_t Scene::instanced_triangles() const {
  std::uint64_t count = triangles(*this, shapes) + triangles(*this, hidden_shapes);
  for (const Instance& instance : instances) count += triangles(*this, objects[instance.object].shapes);
  return count;
}

Scene read_scene(const std::string& name, const ReadOptions& options) {
  const std::filesystem::path path(name);
  const std::string extension = path.extension().string();
  if (extension == ".pbrt") return parse_pbrt(read_file(path), name, options);
  if (extension == ".ply" || extension == ".obj") return read_bare_mesh(path, options);
  throw InputError("\"" + name + "\" is no scene: a scene is a .pbrt, .ply or .obj file");
}

Scene read_scene(const std::string& name, SceneNotes& notes) {
  if (std::filesystem::path(name).extension() != ".pbrt")
    return read_scene(name, ReadOptions{.normals = true, .uvs = true, .images = true});
  return parse_pbrt(read_file(name), name, notes);
}

}  // namespace capcon
