// The scene files as a reader meets them, over geometry that this test has written.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>

#include "scene/scene.h"
#include "scenes/shipped.h"
#include "shading/light.h"
#include "shading/material.h"

namespace capcon {
namespace {

namespace fs = std::filesystem;

std::string kinds_of(const Lights& lights) {
  constexpr const char* kNames[] = {"disk",        "sphere",  "rectangle", "triangles",
                                    "environment", "distant", "point"};
  std::string text;
  for (const Light& light : lights.values) text += std::string(kNames[static_cast<int>(light.kind)]) + " ";
  return text;
}

/// How many of each kind; the default, of shapes that have none, is not counted.
std::string kinds_of(const Materials& materials) {
  int counts[4] = {};
  for (std::size_t i = 0; i + 1 < materials.values.size(); ++i)
    ++counts[static_cast<int>(materials.values[i].kind)];
  return fmt::format("{} diffuse, {} conductor, {} plastic, {} measured", counts[0], counts[1], counts[2],
                     counts[3]);
}

const std::map<std::string, std::string> kLightsOf = {{"courtyard", "sphere environment "},
                                                      {"nave", "sphere "},
                                                      {"direct", "disk "},
                                                      {"splitting", "disk environment "}};
const std::map<std::string, std::string> kMaterialsOf = {
    {"courtyard", "19 diffuse, 0 conductor, 0 plastic, 0 measured"},
    {"nave", "9 diffuse, 0 conductor, 0 plastic, 0 measured"},
    {"direct", "14 diffuse, 0 conductor, 0 plastic, 0 measured"},
    {"splitting", "6 diffuse, 2 conductor, 6 plastic, 1 measured"}};

class SceneFile : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Of, SceneFile, kShippedScenes, [](const auto& info) { return info.param; });

TEST_P(SceneFile, ReadsWithoutWarningsAndHoldsAllTriangles) {
  std::string pattern = (fs::temp_directory_path() / "capcon-scene-XXXXXX").string();
  const fs::path folder = mkdtemp(pattern.data());
  const std::string name = GetParam();
  const scenes::Assembly assembly = shipped_scene(name);
  fs::create_directory(folder / "geometry");
  assembly.write(folder / "geometry");
  if (name == "splitting") scenes::write_terrace_data(folder / "geometry");
  fs::copy_file(fs::path(CAPCON_SOURCE_DIR) / "scenes" / (name + ".pbrt"), folder / (name + ".pbrt"));

  const Scene scene = read_scene((folder / (name + ".pbrt")).string(), {true, true, true});
  const Materials materials = read_materials(scene);
  const Lights lights = read_lights(scene);
  fs::remove_all(folder);
  std::string warnings;
  for (const auto* list : {&scene.warnings, &materials.warnings, &lights.warnings}) {
    for (const std::string& warning : *list) warnings += warning + "\n";
  }
  EXPECT_EQ(warnings, "");
  std::uint64_t triangles = scene.instanced_triangles();
  EXPECT_EQ(triangles, assembly.instanced_triangles());
  EXPECT_FALSE(scene.area_lights.empty());
  EXPECT_EQ(scene.film.width, 640);
  EXPECT_EQ(kinds_of(lights), kLightsOf.at(name));
  EXPECT_EQ(kinds_of(materials), kMaterialsOf.at(name));
  for (const Object& object : scene.objects) {
    for (const Shape& shape : object.shapes) EXPECT_GE(shape.material, 0) << object.name;
  }
}

}  // namespace
}  // namespace capcon
