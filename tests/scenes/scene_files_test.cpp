// The scene files as a reader meets them, over geometry that this test has written.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "generator/courtyard.h"
#include "generator/nave.h"
#include "scene/scene.h"

namespace capcon {
namespace {

namespace fs = std::filesystem;

class SceneFile : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Of, SceneFile, testing::Values("courtyard", "nave"),
                         [](const auto& info) { return info.param; });

TEST_P(SceneFile, ReadsWithoutWarningsAndHoldsAllTriangles) {
  std::string pattern = (fs::temp_directory_path() / "capcon-scene-XXXXXX").string();
  const fs::path folder = mkdtemp(pattern.data());
  const std::string name = GetParam();
  const scenes::Assembly assembly = name == "nave" ? scenes::nave() : scenes::courtyard(1);
  fs::create_directory(folder / "geometry");
  assembly.write(folder / "geometry");
  fs::copy_file(fs::path(CAPCON_SOURCE_DIR) / "scenes" / (name + ".pbrt"), folder / (name + ".pbrt"));

  const Scene scene = read_scene((folder / (name + ".pbrt")).string());
  fs::remove_all(folder);
  std::string warnings;
  for (const std::string& warning : scene.warnings) warnings += warning + "\n";
  EXPECT_EQ(warnings, "");
  std::uint64_t triangles = scene.instanced_triangles();
  EXPECT_EQ(triangles, assembly.instanced_triangles());
  EXPECT_FALSE(scene.area_lights.empty());
  EXPECT_EQ(scene.film.width, 640);
  for (const Object& object : scene.objects) {
    for (const Shape& shape : object.shapes) EXPECT_GE(shape.material, 0) << object.name;
  }
}

}  // namespace
}  // namespace capcon
