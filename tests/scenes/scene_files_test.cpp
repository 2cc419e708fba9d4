// The scene files as a reader meets them, over geometry that this test has written.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "scene/scene.h"
#include "scenes/shipped.h"
#include "shading/light.h"
#include "shading/material.h"

namespace capcon {
namespace {

namespace fs = std::filesystem;

class SceneFile : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Of, SceneFile, kShippedScenes, [](const auto& info) { return info.param; });

TEST_P(SceneFile, ReadsWithoutWarningsAndHoldsAllTriangles) {
  std::string pattern = (fs::temp_directory_path() / "capcon-scene-XXXXXX").string();
  const fs::path folder = mkdtemp(pattern.data());
  const std::string name = GetParam();
  const scenes::Assembly assembly = shipped_scene(name);
  fs::create_directory(folder / "geometry");
  assembly.write(folder / "geometry");
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
  EXPECT_EQ(lights.values.size(), name == "courtyard" ? 2u : 1u);
  if (name == "direct") {
    EXPECT_EQ(lights.values[0].kind, LightKind::disk);
    for (const Material& material : materials.values) EXPECT_EQ(material.kind, MaterialKind::diffuse);
  }
  for (const Object& object : scene.objects) {
    for (const Shape& shape : object.shapes) EXPECT_GE(shape.material, 0) << object.name;
  }
}

}  // namespace
}  // namespace capcon
