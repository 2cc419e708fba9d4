// Scene text with the files that it names, and meshes.
#include <array>
#include <cmath>
#include <filesystem>
#include <set>

#include "fuzz/files.h"
#include "fuzz/scene_check.h"
#include "fuzz/target.h"
#include "scene/obj_reader.h"
#include "scene/pbrt_reader.h"
#include "scene/ply_reader.h"
#include "scene/whole_view.h"
#include "shading/light.h"
#include "shading/material.h"

namespace capcon::fuzz {
namespace {

// What follows a line "%%% NAME" is the file of that name beside the scene. No BRDF tables: fitting their
// sampling takes seconds, and their readers have targets of their own.
constexpr std::string_view kMark = "%%% ";
constexpr std::array<std::string_view, 8> kNames = {"a.pbrt", "b.pbrt", "m.ply", "m.obj",
                                                    "t.png",  "t.exr",  "s.spd", "c.ply"};

std::set<std::string_view> written;  ///< of the input before

/// Writes the files that stand behind the scene, and cuts them off.
std::string_view unpack(std::string_view bytes) {
  const auto next_mark = [&](std::size_t from) { return bytes.find(kMark, from); };
  for (const std::string_view name : written) std::filesystem::remove(scratch_folder() / name);
  written.clear();
  const std::size_t first = next_mark(0);
  for (std::size_t at = first; at != bytes.npos;) {
    const std::size_t end = next_mark(at + kMark.size());
    std::string_view file = bytes.substr(at + kMark.size(), end - at - kMark.size());
    for (const std::string_view name : kNames) {
      if (!file.starts_with(name) || file.size() == name.size() || file[name.size()] != '\n') continue;
      written.insert(name);
      write_plain(scratch_folder() / name, file.substr(name.size() + 1));
    }
    at = end;
  }
  return bytes.substr(0, first);
}

void check_materials(const Materials& materials) {
  for (const Material& material : materials.values) {
    for (int c = 0; c < 3; ++c) {
      require(material.reflectance[c] >= 0 && material.reflectance[c] <= 1, "a reflectance is in [0, 1]");
      require(material.specular[c] >= 0 && material.specular[c] <= 1, "a specular colour is in [0, 1]");
      require(material.eta[c] >= 0 && std::isfinite(material.eta[c]), "eta is 0 or more");
      require(material.k[c] >= 0 && std::isfinite(material.k[c]), "k is 0 or more");
    }
    require(material.alpha > 0 && material.alpha <= 1, "alpha is in (0, 1]");
    require(material.texture < static_cast<int>(materials.textures.size()), "a texture is there");
    require(material.measured < static_cast<int>(materials.measured.size()), "a table is there");
  }
}

void check_lights(const Lights& lights) {
  require(lights.areas.size() == lights.triangles.size(), "an area for each triangle");
  for (const Environment& environment : lights.environments)
    for (int c = 0; c < 3; ++c)
      require(std::isfinite(environment.table.integral[c]), "an environment's light is finite");
  for (const Light& light : lights.values) {
    for (int c = 0; c < 3; ++c)
      require(light.radiance[c] >= 0 && std::isfinite(light.radiance[c]), "light is finite, 0 or more");
    for (int c = 0; c < 3; ++c)
      require(light.power[c] >= 0 && std::isfinite(light.power[c]), "a power is finite, 0 or more");
    require(light.first_triangle + light.triangle_count <= lights.triangles.size(), "triangles are there");
    require(light.area >= 0 && std::isfinite(light.area), "an area is finite, 0 or more");
  }
}

void check_bare(const TriangleMesh& mesh) {
  check_mesh(mesh);
  if (mesh.triangles.empty()) return;
  Scene scene;
  scene.camera = whole_view(mesh);
  check_scene(scene);
}

}  // namespace

void read_pbrt(std::string_view bytes) {
  const std::string_view text = unpack(bytes);
  const std::string path = (scratch_folder() / "scene.pbrt").string();
  SceneNotes notes;  // goes on behind errors, as `capcon check` does
  const Scene listed = parse_pbrt(text, path, notes);
  if (notes.errors.empty()) check_scene(listed);
  check_warnings(notes.errors);
  const Scene scene = parse_pbrt(text, path, {true, true, true});
  require(notes.errors.empty(), "what is read has no errors");
  check_scene(scene);
  const Materials materials = read_materials(scene);
  check_materials(materials);
  check_warnings(materials.warnings);
  const Lights lights = read_lights(scene);
  check_lights(lights);
  check_warnings(lights.warnings);
}

void read_ply(std::string_view bytes) {
  check_bare(parse_ply(bytes, "f.ply", {true, true}));
}

void read_obj(std::string_view bytes) {
  check_bare(parse_obj(bytes, "f.obj", {true, true}));
  check_mesh(parse_obj(bytes, "f.obj", {false, false}));
}

}  // namespace capcon::fuzz
