#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "scene_text.h"

namespace capcon {
namespace {

using test::error_of;
using test::Folder;

TEST(BareMesh, IsSeenWhole) {
  const Folder folder;
  const Scene scene = read_scene(
      folder.write("box.obj", "v -1 10 5\nv 3 10 5\nv 3 12 5\nv -1 12 -5\nv 1e6 0 0\nf 1 2 3 4\n"));
  EXPECT_EQ(scene.name, "box");
  EXPECT_EQ(scene.unique_triangles(), 2u);
  const glm::dmat4 to_camera = glm::inverse(scene.camera.camera_to_world);
  const double edge = std::tan(scene.camera.fov_degrees / 2 * 3.14159265358979323846 / 180);
  double widest = 0;
  for (int i = 0; i < 4; ++i) {
    const glm::dvec3 p(to_camera * glm::dvec4(glm::dvec3(scene.meshes[0].positions[i]), 1));
    ASSERT_GT(p.z, 0);
    widest = std::max({widest, std::abs(p.x / p.z), std::abs(p.y / p.z)});
  }
  EXPECT_LT(widest, edge);
  EXPECT_GT(widest, edge / 4) << "and not from far away: the vertex that no face uses does not count";
  const glm::dvec3 up = glm::dvec3(to_camera * glm::dvec4(0, 1, 0, 0));
  EXPECT_GT(up.y, 0.5) << "y is up";
}

TEST(BareMesh, PlyToo) {
  const Folder folder;
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\nelement face ";
  const std::string tail = "\nproperty list uchar int vertex_indices\nend_header\n0 0 0 1 0 0 0 1 0 ";
  EXPECT_EQ(read_scene(folder.write("a.ply", head + "1" + tail + "3 0 1 2")).unique_triangles(), 1u);
  const std::string empty = folder.write("b.ply", head + "0" + tail);
  EXPECT_EQ(error_of([&] { read_scene(empty); }), empty + ": this mesh has no triangles");
}

TEST(BareMesh, OtherFilesAreNoScenes) {
  EXPECT_EQ(error_of([] { read_scene("scene.stl"); }),
            "\"scene.stl\" is no scene: a scene is a .pbrt, .ply or .obj file");
}

}  // namespace
}  // namespace capcon
