#include "scene/scene_images.h"

#include <fmt/format.h>

#include <exception>

#include "base/parallel.h"

namespace capcon {
namespace {

/// The file that an entity names, or an empty string.
std::string image_file(const Entity& entity) {
  const std::string name = entity.parameters.string("filename", {});
  return name.empty() ? entity.parameters.string("mapname", {}) : name;
}

/// The index in scene.images that this file has or will have, -1 when it cannot be read.
int index_of(PbrtContext& context, const Entity& entity, std::map<std::string, int>& known) {
  const std::string name = image_file(entity);
  if (name.empty()) return -1;
  const std::filesystem::path path = context.resolve(name, entity.place);
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    context.warn(entity.place,
                 fmt::format("the image \"{}\" cannot be found and is left out", path.string()));
    return -1;
  }
  const std::string extension = path.extension().string();
  if (extension != ".exr" && extension != ".png") {
    context.warn(entity.place,
                 fmt::format("the image \"{}\" is neither EXR nor PNG and is left out", path.string()));
    return -1;
  }
  const auto [found, is_new] = known.emplace(path.string(), static_cast<int>(context.scene.images.size()));
  if (is_new) context.scene.images.push_back({path.string(), {}});
  return found->second;
}

}  // namespace

void read_scene_images(PbrtContext& context) {
  std::map<std::string, int> known;
  Scene& scene = context.scene;
  for (Entity& texture : scene.textures) texture.image = index_of(context, texture, known);
  for (Entity& light : scene.lights) light.image = index_of(context, light, known);
  std::vector<std::exception_ptr> errors(scene.images.size());
  parallel_for(scene.images.size(), [&](std::size_t i) {
    try {
      SceneImage& image = scene.images[i];
      image.image = std::filesystem::path(image.file).extension() == ".exr" ? read_exr(image.file)
                                                                            : read_png(image.file);
    } catch (...) {
      errors[i] = std::current_exception();
    }
  });
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

}  // namespace capcon
