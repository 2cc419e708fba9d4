#include "shading/material_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "shading/roughness.h"

namespace capcon {
namespace {

constexpr int kDeepest = 16;  // mixes of mixes; one that holds itself ends here

/// Within [0, 1], 0 for what is no number.
glm::dvec3 bounded(const glm::dvec3& colour) {
  glm::dvec3 result;
  for (int c = 0; c < 3; ++c) result[c] = colour[c] > 0 ? std::min(colour[c], 1.0) : 0;
  return result;
}

/// The file of that name, beside the scene or beside the file that names it; empty when there is none.
std::filesystem::path find_file(const Scene& scene, const std::string& name, const SourcePlace& place) {
  std::error_code error;
  const std::filesystem::path here = std::filesystem::path(place.file).parent_path();
  for (const std::filesystem::path& folder : {std::filesystem::path(scene.folder), here}) {
    if (std::filesystem::is_regular_file(folder / name, error)) return folder / name;
  }
  return {};
}

}  // namespace

void MaterialReader::say(const std::string& phrase) {
  if (std::find(said_.begin(), said_.end(), phrase) == said_.end()) said_.push_back(phrase);
}

void MaterialReader::albedo(Material& material, const std::string& name, double fallback, double factor) {
  const Parameters::Entry* entry = find_entry(entity_.parameters, name);
  if (!entry || entry->type != "texture") {
    material.reflectance = factor * reflectance(name, glm::dvec3(fallback));
    return;
  }
  const std::string wanted = entity_.parameters.string(name, {});
  const Entity* found = find_texture(scene_, wanted, "spectrum");
  if (!found) throw InputError(entry->place, fmt::format("there is no texture named \"{}\"", wanted));
  std::vector<std::string> phrases;
  Texture texture = read_texture(scene_, *found, glm::dvec3(fallback), phrases);
  for (const std::string& phrase : phrases) say(phrase);
  texture.factor *= factor;
  texture.average *= factor;
  material.reflectance = bounded(texture.average);
  if (texture.image < 0) return;
  material.texture = static_cast<int>(materials_.textures.size());
  materials_.textures.push_back(texture);
}

glm::dvec3 MaterialReader::colour(const std::string& name, const glm::dvec3& fallback) {
  const Parameters::Entry* entry = find_entry(entity_.parameters, name);
  if (!entry || entry->type != "texture")
    return read_colour(entity_.parameters, name, ColourUse::reflectance, fallback);
  const std::string wanted = entity_.parameters.string(name, {});
  const Entity* found = find_texture(scene_, wanted, "spectrum");
  if (!found) throw InputError(entry->place, fmt::format("there is no texture named \"{}\"", wanted));
  std::vector<std::string> phrases;
  const Texture texture = read_texture(scene_, *found, fallback, phrases);
  if (texture.image >= 0) say(fmt::format("the texture of \"{}\" is its mean", name));
  for (const std::string& phrase : phrases) say(phrase);
  return texture.average;
}

glm::dvec3 MaterialReader::reflectance(const std::string& name, const glm::dvec3& fallback) {
  const glm::dvec3 value = colour(name, fallback), within = bounded(value);
  if (within != value) say(fmt::format("\"{}\" is bounded by 1", name));
  return within;
}

double MaterialReader::number(const std::string& name, double fallback) {
  const Parameters::Entry* entry = find_entry(entity_.parameters, name);
  if (!entry || entry->type != "texture") return read_number(entity_.parameters, name, fallback, 0);
  const std::string wanted = entity_.parameters.string(name, {});
  const Entity* found = find_texture(scene_, wanted, "float");
  if (!found) throw InputError(entry->place, fmt::format("there is no texture named \"{}\"", wanted));
  std::vector<std::string> phrases;
  const Texture texture = read_texture(scene_, *found, glm::dvec3(fallback), phrases);
  if (texture.image >= 0 || !phrases.empty()) say(fmt::format("the texture of \"{}\" is its mean", name));
  return std::max(0.0, (texture.average.x + texture.average.y + texture.average.z) / 3);
}

double MaterialReader::roughness(double fallback, const std::string& prefix) {
  const double both = number(prefix + "roughness", fallback);
  const double u = number(prefix + "uroughness", both), v = number(prefix + "vroughness", both);
  if (u != v) say("it is equally rough in all directions");
  return std::sqrt(u * v);
}

double MaterialReader::alpha_new(double fallback, const std::string& prefix) {
  const double r = roughness(fallback, prefix);
  return entity_.parameters.boolean("remaproughness", true) ? alpha_of_v4(r)
                                                            : std::clamp(r, kSmallestAlpha, 1.0);
}

double MaterialReader::alpha_old(double fallback) {
  const double r = roughness(fallback, {});
  if (!entity_.parameters.boolean("remaproughness", true)) return std::clamp(r, kSmallestAlpha, 1.0);
  const bool is_v3 = std::any_of(
      scene_.materials.begin(), scene_.materials.end(),
      [](const Entity& material) { return material.parameters.entries.contains("remaproughness"); });
  return is_v3 ? alpha_of_v3(r) : alpha_of_v2(r);
}

int MaterialReader::measured(const std::string& file) {
  const std::filesystem::path path = find_file(scene_, file, entity_.place);
  if (path.empty()) {
    say(fmt::format("the BRDF \"{}\" cannot be found, and it is grey", file));
    return -1;
  }
  const auto [found, is_new] = files_.emplace(path.string(), static_cast<int>(materials_.measured.size()));
  if (is_new) materials_.measured.push_back(read_measured_brdf(path));
  for (const std::string& remark : materials_.measured[found->second].remarks) say(remark);
  return found->second;
}

Material MaterialReader::other(const std::string& name) {
  if (depth_ >= kDeepest) throw InputError(entity_.place, "this mix holds itself");
  const auto found = std::find_if(scene_.materials.rbegin(), scene_.materials.rend(),
                                  [&](const Entity& material) { return material.name == name; });
  if (name.empty() || found == scene_.materials.rend()) {
    say(fmt::format("its part \"{}\" is not defined, and it is grey", name));
    return {};
  }
  MaterialReader reader(scene_, materials_, files_, *found, depth_ + 1);
  return read_material(reader);
}

}  // namespace capcon
