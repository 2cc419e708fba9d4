#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "scene/tessellate.h"
#include "scene_text.h"

namespace capcon {
namespace {

using test::Folder;
using test::parse_world;

const char* const kQuad =
    "Shape \"trianglemesh\" \"point P\" [0 0 0  1 0 0  1 1 0  0 1 0] \"integer indices\" [0 1 2 0 2 3]\n"
    "\"normal N\" [0 0 1 0 0 1 0 0 1 0 0 1]";

TEST(PbrtShape, TriangleMesh) {
  const Scene scene = parse_world(kQuad);
  const TriangleMesh& mesh = scene.meshes.at(0);
  ASSERT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.positions[2], glm::vec3(1, 1, 0));
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.triangles[1], glm::uvec3(0, 2, 3));
  EXPECT_TRUE(mesh.normals.empty()) << "not asked for";
  EXPECT_EQ(scene.unique_triangles(), 2u);
}

TEST(PbrtShape, NormalsAndUvsWhereAskedFor) {
  for (const std::string uv : {"\"point2 uv\"", "\"float uv\"", "\"float st\""}) {
    const Scene scene = parse_world(kQuad + (" " + uv + " [0 0 1 0 1 1 0 1]"), {true, true});
    ASSERT_EQ(scene.meshes.at(0).uvs.size(), 4u) << uv;
    EXPECT_EQ(scene.meshes[0].uvs[1], glm::vec2(1, 0));
    ASSERT_EQ(scene.meshes[0].normals.size(), 4u);
    EXPECT_EQ(scene.meshes[0].normals[3], glm::vec3(0, 0, 1));
  }
}

TEST(PbrtShape, OneTriangleNeedsNoIndices) {
  EXPECT_EQ(parse_world("Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0]").unique_triangles(), 1u);
}

TEST(PbrtShape, SpheresAndDisksStayExact) {
  const Scene scene = parse_world(
      "Shape \"sphere\" \"float radius\" 2.5 \"float phimax\" 360 \"float zmin\" -9\n"
      "Shape \"disk\" \"float radius\" 3 \"float innerradius\" 1 \"float height\" -2");
  EXPECT_EQ(scene.shapes.at(0).kind, ShapeKind::sphere);
  EXPECT_EQ(scene.shapes[0].radius, 2.5);
  EXPECT_EQ(scene.shapes.at(1).kind, ShapeKind::disk);
  EXPECT_EQ(scene.shapes[1].inner_radius, 1);
  EXPECT_EQ(scene.shapes[1].height, -2);
  EXPECT_TRUE(scene.meshes.empty());
}

struct Measure {
  double area = 0;
  double volume =
      0;  ///< under the triangles as seen from the origin, greater than 0 when they face away from it
  glm::dvec3 normal{0};
};

Measure measure(const TriangleMesh& mesh) {
  Measure m;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    const glm::dvec3 normal = glm::cross(b - a, c - a) / 2.0;
    EXPECT_GT(glm::length(normal), 0) << "a degenerate triangle";
    m.area += glm::length(normal);
    m.volume += glm::dot(a, glm::cross(b, c)) / 6;
    m.normal += normal;
  }
  return m;
}

constexpr double kPi = 3.14159265358979323846;

TEST(PbrtShape, PartsOfSpheresAreFineMeshes) {
  // A quarter of the zone between z = -1 and z = 1 of a sphere of radius 2: area 2 pi r h / 4.
  const Scene scene = parse_world(
      "Shape \"sphere\" \"float radius\" 2 \"float zmin\" -1 \"float zmax\" 1 \"float phimax\" 90");
  ASSERT_EQ(scene.shapes.at(0).kind, ShapeKind::mesh);
  const Measure zone = measure(scene.meshes.at(0));
  EXPECT_NEAR(zone.area, 2 * kPi, 1e-3);
  EXPECT_GT(zone.volume, 0) << "outwards";
  for (const glm::vec3& p : scene.meshes[0].positions) {
    EXPECT_NEAR(glm::length(p), 2, 1e-5);
    EXPECT_TRUE(p.x > -1e-5 && p.y > -1e-5 && std::abs(p.z) < 1.00001) << p.x << ' ' << p.y << ' ' << p.z;
  }
  const Measure ball = measure(tessellate_sphere(1, -1, 1, 360));
  EXPECT_NEAR(ball.area, 4 * kPi, 1e-3);
  EXPECT_NEAR(ball.volume, 4 * kPi / 3, 1e-3);
}

TEST(PbrtShape, PartsOfDisksAreFineMeshes) {
  const Scene scene = parse_world(
      "Shape \"disk\" \"float radius\" 2 \"float innerradius\" 1 \"float phimax\" 180 \"float height\" 3");
  const Measure half = measure(scene.meshes.at(0));
  EXPECT_NEAR(half.area, kPi * 1.5, 1e-3);
  EXPECT_NEAR(half.normal.z, half.area, 1e-9) << "towards +z";
  EXPECT_EQ(scene.meshes[0].positions[0], glm::vec3(2, 0, 3));
  EXPECT_NEAR(measure(tessellate_disk(1, 0, 0, 90)).area, kPi / 4, 1e-3);
}

TEST(PbrtShape, SubdivisionShowsItsControlMesh) {
  const Scene scene = parse_world(
      "Shape \"loopsubdiv\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"integer indices\" [0 1 2] \"integer levels\" "
      "3");
  EXPECT_EQ(scene.unique_triangles(), 1u);
  EXPECT_EQ(scene.warnings.size(), 1u);
}

TEST(PbrtShape, AlphaZeroHidesWithoutRemoving) {
  const Scene scene = parse_world(
      "AreaLightSource \"diffuse\" Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"float alpha\" "
      "0\n"
      "Shape \"sphere\" \"float alpha\" 1 Shape \"sphere\" \"texture alpha\" \"leaf\"");
  EXPECT_EQ(scene.hidden_shapes.size(), 1u);
  EXPECT_EQ(scene.hidden_shapes[0].area_light, 0);
  EXPECT_EQ(scene.shapes.size(), 2u);
  EXPECT_EQ(scene.unique_triangles(), 1u);
  EXPECT_EQ(scene.warnings.size(), 1u) << "of the alpha texture";
}

const char* const kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

TEST(PbrtShape, MeshFilesAreReadOnce) {
  const Folder folder;
  folder.write("geometry/a.ply", kPly);
  folder.write("b.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  const std::string main =
      folder.write("main.pbrt",
                   "WorldBegin Shape \"plymesh\" \"string filename\" \"geometry/a.ply\" Shape \"objmesh\" "
                   "\"string filename\" [\"b.obj\"]\n"
                   "Shape \"plymesh\" \"string filename\" \"geometry/../geometry/a.ply\" Shape \"plymesh\" "
                   "\"string filename\" \"no.ply\"");
  const Scene scene = read_scene(main);
  ASSERT_EQ(scene.shapes.size(), 3u);
  EXPECT_EQ(scene.meshes.size(), 2u);
  EXPECT_EQ(scene.shapes[0].mesh, scene.shapes[2].mesh);
  EXPECT_EQ(scene.unique_triangles(), 4u);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_EQ(scene.warnings[0], main + ":2:80: the mesh file \"" + folder.path("no.ply") +
                                   "\" cannot be found; its shape was left out");
}

TEST(PbrtShape, TheFirstBrokenMeshFileIsReported) {
  const Folder folder;
  std::string text = "WorldBegin\n";
  for (int i = 0; i < 8; ++i) {
    const std::string name = std::to_string(i) + ".ply";
    folder.write(name, i < 3 ? std::string(kPly) : "plyy\n");
    text += "Shape \"plymesh\" \"string filename\" \"" + name + "\"\n";
  }
  const std::string main = folder.write("main.pbrt", text);
  EXPECT_EQ(test::error_of([&] { read_scene(main); }),
            folder.path("3.ply") + ":1: this is no PLY file: its first line is not \"ply\"");
}

}  // namespace
}  // namespace capcon
