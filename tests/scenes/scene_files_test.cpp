// The scene files as a reader meets them, over geometry that this test has written.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>

#include "generator/lights.h"
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

/// A scene file read in a folder of its own, where the generator has put what it names.
struct Read {
  explicit Read(const std::string& name, const scenes::Assembly* assembly = nullptr) {
    std::string pattern = (fs::temp_directory_path() / "capcon-scene-XXXXXX").string();
    const fs::path folder = mkdtemp(pattern.data());
    fs::create_directory(folder / "geometry");
    if (assembly) assembly->write(folder / "geometry");
    if (!assembly || name == "splitting") scenes::write_terrace_data(folder / "geometry");
    if (!assembly) scenes::write_lights_data(folder / "geometry");
    const fs::path file = folder / (name + ".pbrt");
    fs::copy_file(fs::path(CAPCON_SOURCE_DIR) / "scenes" / (name + ".pbrt"), file);
    scene = read_scene(file.string(), {true, true, true});
    materials = read_materials(scene);
    lights = read_lights(scene);
    fs::remove_all(folder);
    for (const auto* list : {&scene.warnings, &materials.warnings, &lights.warnings}) {
      for (const std::string& warning : *list) warnings += warning + "\n";
    }
  }
  Scene scene;
  Materials materials;
  Lights lights;
  std::string warnings;
};

class SceneFile : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Of, SceneFile, kShippedScenes, [](const auto& info) { return info.param; });

TEST_P(SceneFile, ReadsWithoutWarningsAndHoldsAllTriangles) {
  const std::string name = GetParam();
  const scenes::Assembly assembly = shipped_scene(name);
  const Read read(name, &assembly);
  const Scene& scene = read.scene;
  EXPECT_EQ(read.warnings, "");
  EXPECT_EQ(scene.instanced_triangles(), assembly.instanced_triangles());
  EXPECT_FALSE(scene.area_lights.empty());
  EXPECT_EQ(scene.film.width, 640);
  EXPECT_EQ(kinds_of(read.lights), kLightsOf.at(name));
  EXPECT_EQ(kinds_of(read.materials), kMaterialsOf.at(name));
  for (const Object& object : scene.objects) {
    for (const Shape& shape : object.shapes) EXPECT_GE(shape.material, 0) << object.name;
  }
}

TEST(LightsScene, HasEveryKindOfLightAndMaterial) {
  const Read read("lights");
  EXPECT_EQ(read.warnings, "");
  EXPECT_EQ(kinds_of(read.lights),
            "disk sphere rectangle triangles disk environment environment distant point ");
  EXPECT_EQ(kinds_of(read.materials), "2 diffuse, 2 conductor, 4 plastic, 1 measured");
  EXPECT_TRUE(read.lights.values[2].two_sided);
  EXPECT_TRUE(read.lights.values[4].hidden);
  std::set<Coat> coats;
  for (const Material& material : read.materials.values) {
    if (material.kind == MaterialKind::plastic) coats.insert(material.coat);
  }
  EXPECT_EQ(coats.size(), 3u);
  EXPECT_EQ(read.materials.textures.size(), 2u);
  EXPECT_EQ(read.scene.instanced_triangles(), 24u);
}

TEST(LightsScene, TileRepeatsWithoutASeam) {
  const Image tile = scenes::painted_tile(64);
  for (int i = 0; i < 64; ++i) {
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(tile.at(0, i, c), tile.at(63, i, c), 1e-6);
      EXPECT_NEAR(tile.at(i, 0, c), tile.at(i, 63, c), 1e-6);
    }
  }
}

}  // namespace
}  // namespace capcon
