#include "shading/scene_check.h"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <map>

#include "shading/light.h"
#include "shading/material_reader.h"

namespace capcon {
namespace {

/// "file:line:column: sentence" taken apart.
std::pair<SourcePlace, std::string> taken_apart(const std::string& warning) {
  for (std::size_t at = warning.find(": "); at != warning.npos; at = warning.find(": ", at + 1)) {
    const std::size_t second = warning.rfind(':', at - 1);
    const std::size_t first =
        second == warning.npos || second == 0 ? warning.npos : warning.rfind(':', second - 1);
    if (first == warning.npos) continue;
    SourcePlace place{warning.substr(0, first), 0, 0};
    const char *text = warning.data(), *end = text + at;
    const auto line = std::from_chars(text + first + 1, end, place.line);
    const auto column = std::from_chars(text + second + 1, end, place.column);
    if (line.ptr == text + second && column.ptr == end) return {place, warning.substr(at + 2)};
  }
  return {{}, warning};
}

void check_materials(SceneCheck& check) {
  Materials materials;
  std::map<std::string, int> files;
  for (const Entity& entity : check.scene.materials) {
    MaterialReader reader(check.scene, materials, files, entity, 0);
    try {
      read_material(reader);
    } catch (const InputError& error) {
      check.shading_errors.emplace_back(error.what());
    }
    for (const std::string& phrase : reader.said()) {
      check.notes.add(NoteKind::approximated, entity.place,
                      fmt::format("material \"{}\": {}", entity.type, phrase));
    }
  }
}

void check_lights(SceneCheck& check) {
  try {
    const Lights lights = read_lights(check.scene);
    check.lights = lights.values.size();
    for (const std::string& warning : lights.warnings) {
      const auto [place, sentence] = taken_apart(warning);
      if (check.lights > 0 || !place.file.empty()) check.notes.add_warning(place, sentence);
    }
  } catch (const InputError& error) {
    check.shading_errors.emplace_back(error.what());
  }
}

}  // namespace

SceneCheck check_scene(const std::string& path) {
  SceneCheck check;
  check.scene = read_scene(path, check.notes);
  if (!check.can_be_seen()) return check;  // what follows from errors says nothing
  check_materials(check);
  check_lights(check);
  return check;
}

}  // namespace capcon
