#include <fmt/format.h>

#include <glm/common.hpp>
#include <utility>

#include "shading/colours.h"
#include "shading/texture.h"

namespace capcon {
namespace {

constexpr int kDeepest = 16;  // textures that name textures; one that names itself ends here

Texture constant(const glm::dvec3& colour) {
  Texture texture;
  texture.average = colour;
  return texture;
}

glm::dvec3 mean(const Texture& texture, const Image& image) {
  glm::dvec3 sum(0);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) sum += texel(texture, image, x, y);
  }
  return texture.factor * sum / (static_cast<double>(image.width) * image.height);
}

/// Whether the numbers of an 8-bit file are linear although read_png took them for sRGB: pbrt-v4's "string
/// encoding" "linear", pbrt-v3's "bool gamma" false.
bool is_linear(const Parameters& parameters) {
  if (parameters.string("encoding", "sRGB") == "linear") return true;
  const Parameters::Entry* gamma = find_entry(parameters, "gamma");
  return gamma && gamma->type == "bool" && !parameters.boolean("gamma", true);
}

class TextureReader {
 public:
  TextureReader(const Scene& scene, const glm::dvec3& missing, std::vector<std::string>& approximations)
      : scene_(scene), missing_(missing), approximations_(approximations) {}

  Texture read(const Entity& entity, int depth) {
    if (depth > kDeepest)
      throw InputError(entity.place, fmt::format("the texture \"{}\" names itself", entity.name));
    if (entity.type == "imagemap") return image_map(entity);
    if (entity.type == "constant") return parameter(entity, "value", 1, depth);
    if (entity.type == "scale") return scaled(entity, depth);
    if (entity.type == "mix") return mixed(entity, depth);
    if (entity.type == "checkerboard") {
      const Texture one = parameter(entity, "tex1", 1, depth), two = parameter(entity, "tex2", 0, depth);
      approximate("checkerboard", 0.5 * (one.average + two.average));
      return constant(0.5 * (one.average + two.average));
    }
    approximate(entity.type, missing_);
    return constant(missing_);
  }

 private:
  void approximate(const std::string& type, const glm::dvec3& colour) {
    approximations_.push_back(fmt::format("its texture \"{}\" is the constant {:.3g} {:.3g} {:.3g}", type,
                                          colour.x, colour.y, colour.z));
  }

  /// A colour, or the texture that it names.
  Texture parameter(const Entity& entity, const std::string& name, double fallback, int depth) {
    const Parameters::Entry* entry = find_entry(entity.parameters, name);
    if (entry && entry->type == "texture") {
      const std::string wanted = entity.parameters.string(name, {});
      if (const Entity* found = find_texture(scene_, wanted, entity.values)) return read(*found, depth + 1);
      throw InputError(entry->place, fmt::format("there is no texture named \"{}\"", wanted));
    }
    return constant(read_colour(entity.parameters, name, ColourUse::reflectance, glm::dvec3(fallback)));
  }

  Texture image_map(const Entity& entity) {
    const Parameters& parameters = entity.parameters;
    Texture texture;
    texture.factor = glm::dvec3(read_number(parameters, "scale", 1, 0));
    texture.invert = parameters.boolean("invert", false);
    const std::string wrap = parameters.string("wrap", "repeat");
    texture.wrap = wrap == "clamp" ? Wrap::clamp : wrap == "black" ? Wrap::black : Wrap::repeat;
    texture.scale = {parameters.number("uscale", 1), parameters.number("vscale", 1)};
    texture.offset = {parameters.number("udelta", 0), parameters.number("vdelta", 0)};
    texture.image = entity.image;
    if (texture.image < 0) {  // the reader has said why
      texture.average = missing_;
      return texture;
    }
    const SceneImage& image = scene_.images[texture.image];
    texture.encode = image.file.ends_with(".png") && is_linear(parameters);
    texture.average = mean(texture, image.image);
    if (parameters.string("mapping", "uv") != "uv") {
      approximate("imagemap", texture.average);
      texture.image = -1;
    }
    return texture;
  }

  Texture scaled(const Entity& entity, int depth) {
    // pbrt-v2 and v3 multiply tex1 and tex2, pbrt-v4 tex and scale.
    const bool is_new = entity.parameters.entries.contains("tex");
    Texture texture = parameter(entity, is_new ? "tex" : "tex1", 1, depth);
    Texture other = parameter(entity, is_new ? "scale" : "tex2", 1, depth);
    if (texture.image < 0) std::swap(texture, other);
    if (other.image >= 0) approximate("imagemap", other.average);
    texture.factor *= other.average;
    texture.average *= other.average;
    return texture;
  }

  Texture mixed(const Entity& entity, int depth) {
    const Texture one = parameter(entity, "tex1", 0, depth), two = parameter(entity, "tex2", 1, depth);
    const Texture amount = parameter(entity, "amount", 0.5, depth);
    const glm::dvec3 part = glm::clamp(amount.average, 0.0, 1.0);
    const glm::dvec3 colour = (1.0 - part) * one.average + part * two.average;
    if (one.image >= 0 || two.image >= 0 || amount.image >= 0) approximate("mix", colour);
    return constant(colour);
  }

  const Scene& scene_;
  glm::dvec3 missing_;
  std::vector<std::string>& approximations_;
};

}  // namespace

Texture read_texture(const Scene& scene, const Entity& entity, const glm::dvec3& missing,
                     std::vector<std::string>& approximations) {
  return TextureReader(scene, missing, approximations).read(entity, 0);
}

const Entity* find_texture(const Scene& scene, const std::string& name, const std::string& values) {
  const Entity* found = nullptr;
  for (const Entity& texture : scene.textures) {
    const bool better = texture.values == values || !found || found->values != values;
    if (texture.name == name && better) found = &texture;
  }
  return found;
}

}  // namespace capcon
