#include "shading/material.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "shading/material_reader.h"

namespace capcon {

Materials read_materials(const Scene& scene) {
  Materials materials;
  std::map<std::string, int> files;
  for (const Entity& entity : scene.materials) {
    MaterialReader reader(scene, materials, files, entity, 0);
    materials.values.push_back(read_material(reader));
    if (reader.said().empty()) continue;
    const std::string name = entity.name.empty() ? "" : fmt::format(" \"{}\"", entity.name);
    materials.warnings.push_back(one_line(fmt::format("{}: the material{} ({}): {}", entity.place.str(), name,
                                                      entity.type, fmt::join(reader.said(), "; "))));
  }
  materials.values.emplace_back();
  return materials;
}

}  // namespace capcon
