#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "scene/scene.h"

namespace capcon {
namespace {

struct Case {
  const char* name;
  const char* path;
  std::uint64_t unique;
  std::uint64_t instanced;
  std::size_t warnings;
};

/// Scenes that lie beside a checkout on our machines, with the counts that their owners state.
class SharedScene : public testing::TestWithParam<Case> {};

TEST_P(SharedScene, LoadsWithItsTriangles) {
  const std::filesystem::path path = std::filesystem::path(CAPCON_SHARED_DIR) / GetParam().path;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
  const auto start = std::chrono::steady_clock::now();
  const Scene scene = read_scene(path.string());
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  RecordProperty("seconds", std::to_string(seconds.count()));
  EXPECT_EQ(scene.unique_triangles(), GetParam().unique);
  EXPECT_EQ(scene.instanced_triangles(), GetParam().instanced);
  EXPECT_EQ(scene.warnings.size(), GetParam().warnings);
  EXPECT_LT(seconds.count(), 10) << "a scene of this size takes a fraction of a second";
}

INSTANTIATE_TEST_SUITE_P(
    All, SharedScene,
    testing::Values(Case{"A", "anchors/A.pbrt", 212298, 212298, 0},
                    Case{"B", "anchors/B.pbrt", 104999, 104999, 0},
                    Case{"C", "anchors/C.pbrt", 104985, 104985, 0},
                    Case{"D", "anchors/D.pbrt", 103005, 103005, 0},
                    Case{"SanMiguelBuilding", "scenes/sanmiguel/sanmiguel-building.pbrt", 321103, 1012685, 4},
                    Case{"SanMiguel", "scenes/sanmiguel/sanmiguel.pbrt", 650793, 6892559, 5},
                    Case{"Sibenik", "scenes/sibenik/sibenik-geometry.pbrt", 75284, 75284, 0}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(SharedSceneCamera, OfTheAnchorsIsAsTheyState) {
  const std::filesystem::path path = std::filesystem::path(CAPCON_SHARED_DIR) / "anchors/A.pbrt";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
  const Scene scene = read_scene(path.string());
  // "image_right = cross(up, forward)": an eye at z = -11 that looks to +z has +x on the right.
  const glm::dvec4 right = scene.camera.camera_to_world[0], eye = scene.camera.camera_to_world[3];
  EXPECT_NEAR(right.x, 1, 1e-12);
  EXPECT_NEAR(eye.y, 4.5, 1e-12);
  EXPECT_NEAR(eye.z, -11, 1e-12);
  EXPECT_EQ(scene.camera.fov_degrees, 40);
  EXPECT_EQ(scene.film.width, 256);
}

}  // namespace
}  // namespace capcon
