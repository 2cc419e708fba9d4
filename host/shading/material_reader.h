#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "shading/colours.h"
#include "shading/material.h"

namespace capcon {

/// Reads the parameters of one material entity, and collects what was approximated. The functions on it, one
/// for each of pbrt's names, are listed by material_types().
class MaterialReader {
 public:
  MaterialReader(const Scene& scene, Materials& materials, std::map<std::string, int>& files,
                 const Entity& entity, int depth)
      : scene_(scene), materials_(materials), files_(files), entity_(entity), depth_(depth) {}

  const Entity& entity() const { return entity_; }
  const Scene& scene() const { return scene_; }
  int depth() const { return depth_; }
  /// Adds a phrase to what is said of the material, once.
  void say(const std::string& phrase);
  const std::vector<std::string>& said() const { return said_; }
  bool has(const std::string& name) const { return find_entry(entity_.parameters, name) != nullptr; }

  /// The base of a material: a colour in [0, 1] times `factor`, or a texture.
  void albedo(Material& material, const std::string& name, double fallback, double factor = 1);
  /// A colour; a texture becomes its mean, which is said. In [0, 1] if it is a reflectance.
  glm::dvec3 colour(const std::string& name, const glm::dvec3& fallback);
  glm::dvec3 reflectance(const std::string& name, const glm::dvec3& fallback);
  /// A number of 0 or more, a texture's mean too.
  double number(const std::string& name, double fallback);

  /// GGX alpha from `name`, or from uroughness and vroughness: by their geometric mean. `prefix` is
  /// "interface." or "conductor." of pbrt-v4's layers.
  double alpha_new(double fallback, const std::string& prefix = {});
  /// The same for the names of pbrt-v2 and v3: v3's rule where a material of the scene has its
  /// "remaproughness", else v2's.
  double alpha_old(double fallback);

  /// The table of a file, read once a scene; -1 and said when there is no such file.
  int measured(const std::string& file);
  /// Another material of the scene by its name, what is said of it included.
  Material other(const std::string& name);

 private:
  double roughness(double fallback, const std::string& prefix);

  const Scene& scene_;
  Materials& materials_;
  std::map<std::string, int>& files_;
  const Entity& entity_;
  int depth_;
  std::vector<std::string> said_;
};

/// One of pbrt's materials by name.
struct MaterialType {
  std::string_view name;
  Material (*read)(MaterialReader&);
};
const std::vector<MaterialType>& material_types();

/// The material of the reader's entity.
Material read_material(MaterialReader& reader);

}  // namespace capcon
