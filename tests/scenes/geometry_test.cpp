// The generator's meshes as files: sound, small, and the same on every run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "base/file.h"
#include "generator/normals.h"
#include "generator/ply.h"
#include "generator/solids.h"
#include "scenes/shipped.h"

namespace capcon {
namespace {

namespace fs = std::filesystem;

/// A folder of this test alone, removed with it.
class Folder {
 public:
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "capcon-scenes-XXXXXX").string();
    path = mkdtemp(pattern.data());
  }
  ~Folder() { fs::remove_all(path); }
  fs::path path;
};

std::map<std::string, std::string> files_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    files[entry.path().filename().string()] = read_file(entry.path());
  }
  return files;
}

/// What a PLY file of ours holds, read from its bytes by a reader that knows only this one layout.
struct Ply {
  std::vector<std::array<float, 3>> points;
  std::vector<std::array<float, 3>> normals;  // empty or one a point
  std::vector<std::array<std::int32_t, 3>> triangles;
};
Ply parse(const std::string& bytes) {
  const auto count = [&](const std::string& word) {
    return std::stoul(bytes.substr(bytes.find("element " + word) + 9 + word.size()));
  };
  Ply ply;
  ply.points.resize(count("vertex"));
  ply.triangles.resize(count("face"));
  std::size_t at = bytes.find("end_header\n") + 11;
  if (bytes.find("property float nx\n") < at) ply.normals.resize(ply.points.size());
  EXPECT_EQ(bytes.size(), at + 12 * (ply.points.size() + ply.normals.size()) + 13 * ply.triangles.size());
  for (std::size_t i = 0; i < ply.points.size(); ++i) {
    std::memcpy(ply.points[i].data(), bytes.data() + at, 12);
    at += 12;
    if (ply.normals.empty()) continue;
    std::memcpy(ply.normals[i].data(), bytes.data() + at, 12);
    at += 12;
  }
  for (auto& t : ply.triangles) {
    EXPECT_EQ(bytes[at], 3);
    std::memcpy(t.data(), bytes.data() + at + 1, 12);
    at += 13;
  }
  return ply;
}

double area(const Ply& ply, const std::array<std::int32_t, 3>& t) {
  std::array<double, 3> u, v;
  for (int k = 0; k < 3; ++k) {
    u[k] = static_cast<double>(ply.points[t[1]][k]) - ply.points[t[0]][k];
    v[k] = static_cast<double>(ply.points[t[2]][k]) - ply.points[t[0]][k];
  }
  return 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}

TEST(Geometry, TwoRunsWriteTheSameBytes) {
  const Folder first, second;
  for (const Folder* folder : {&first, &second}) {
    for (const char* name : {"courtyard", "nave", "direct", "splitting"})
      shipped_scene(name).write(folder->path);
    scenes::write_terrace_data(folder->path);
  }
  const auto a = files_of(first.path), b = files_of(second.path);
  EXPECT_GT(a.size(), 50u);
  EXPECT_TRUE(a == b);
  std::size_t bytes = 0;
  for (const auto& [name, content] : a) bytes += content.size();
  EXPECT_LT(bytes, 32u << 20);
}

TEST(Geometry, TriangleCountsAreAsDocumented) {
  const scenes::Assembly court = scenes::courtyard(1), nave = scenes::nave();
  EXPECT_THAT(court.unique_triangles(), testing::AllOf(testing::Ge(60'000u), testing::Le(150'000u)));
  EXPECT_GE(court.instanced_triangles(), 300'000u);
  EXPECT_THAT(nave.instanced_triangles(), testing::AllOf(testing::Ge(80'000u), testing::Le(150'000u)));
  for (const scenes::Assembly& scene : {scenes::atelier(), scenes::terrace()}) {
    EXPECT_THAT(scene.unique_triangles(), testing::AllOf(testing::Ge(80'000u), testing::Le(120'000u)));
    EXPECT_THAT(scene.instanced_triangles(), testing::AllOf(testing::Ge(80'000u), testing::Le(152'000u)));
  }
  const scenes::Assembly four = scenes::courtyard(2);
  EXPECT_EQ(four.unique_triangles(), court.unique_triangles());
  EXPECT_EQ(four.instanced_triangles(), 4 * court.instanced_triangles());
}

class EveryMesh : public testing::TestWithParam<const char*> {
 protected:
  scenes::Assembly scene() const { return shipped_scene(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Of, EveryMesh, kShippedScenes, [](const auto& info) { return info.param; });

TEST_P(EveryMesh, IsFiniteIndexedAndWithoutSliversOrTwins) {
  const scenes::Assembly assembly = scene();
  for (const auto& [name, entry] : assembly.entries()) {
    EXPECT_FALSE(entry.model.parts.empty()) << name;
    EXPECT_FALSE(entry.places.empty()) << name << " stands nowhere";
    for (const auto& part : entry.model.parts) {
      SCOPED_TRACE(name + ", " + part.material);
      const Ply ply = parse(scenes::ply_bytes(part.mesh));
      ASSERT_FALSE(ply.triangles.empty());
      for (const auto& p : ply.points) {
        ASSERT_TRUE(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]));
      }
      for (const auto& n : ply.normals) ASSERT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-6);
      std::set<std::array<std::array<float, 3>, 3>> seen;
      for (const auto& t : ply.triangles) {
        for (const std::int32_t i : t) ASSERT_TRUE(i >= 0 && static_cast<std::size_t>(i) < ply.points.size());
        ASSERT_GT(area(ply, t), 1e-12);
        std::array<std::array<float, 3>, 3> corners = {ply.points[t[0]], ply.points[t[1]], ply.points[t[2]]};
        std::sort(corners.begin(), corners.end());
        ASSERT_TRUE(seen.insert(corners).second)
            << "twice at " << corners[0][0] << " " << corners[0][1] << " " << corners[0][2];
      }
    }
  }
}

TEST_P(EveryMesh, LiesWithinAFewTensOfMetres) {
  const scenes::Assembly assembly = scene();
  for (const auto& [name, entry] : assembly.entries()) {
    for (const scenes::Matrix& where : entry.places) {
      for (const auto& part : entry.model.parts) {
        for (const scenes::Vec3& p : part.mesh.positions) {
          const scenes::Vec3 q = scenes::apply(where, p);
          ASSERT_TRUE(std::abs(q.x) < 40 && std::abs(q.y) < 12 && q.z > -1 && q.z < 18) << name;
        }
      }
    }
  }
}

/// A smoothed triangle's normals must not lie on its other side: that would turn its light around.
TEST_P(EveryMesh, HasNormalsOnTheSideThatItsTrianglesFace) {
  const scenes::Assembly assembly = scene();
  for (const auto& [name, entry] : assembly.entries()) {
    for (const auto& part : entry.model.parts) {
      const scenes::Mesh& mesh = part.mesh;
      if (mesh.normals.empty()) continue;
      for (const glm::uvec3& t : mesh.triangles) {
        const scenes::Vec3 face = glm::normalize(
            glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]));
        for (int k = 0; k < 3; ++k) ASSERT_GT(glm::dot(face, mesh.normals[t[k]]), 0.5) << name;
      }
    }
  }
}

TEST(Normals, OfASphereAreRadial) {
  scenes::Model model;
  std::vector<scenes::Vec2> profile;
  for (int i = 0; i <= 32; ++i)
    profile.emplace_back(std::sin(scenes::kPi * i / 32), -std::cos(scenes::kPi * i / 32));
  profile.front().x = profile.back().x = 0;
  scenes::Mesh mesh = scenes::lathe(profile, 64);
  scenes::add_normals(mesh, 30);
  EXPECT_EQ(mesh.positions.size(), 31u * 64 + 2);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    EXPECT_GT(glm::dot(mesh.normals[i], mesh.positions[i]), 0.9999) << i;
}

TEST(Normals, OfABoxStayThoseOfItsFaces) {
  scenes::Mesh mesh = scenes::box({-1, -1, -1}, {1, 1, 1}), welded;
  for (int corner = 0; corner < 8; ++corner)
    welded.vertex({corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1});
  for (const glm::uvec3& t : mesh.triangles) {
    glm::uvec3 corners;
    for (int k = 0; k < 3; ++k) {
      const scenes::Vec3& p = mesh.positions[t[k]];
      corners[k] = (p.x > 0 ? 1 : 0) + (p.y > 0 ? 2 : 0) + (p.z > 0 ? 4 : 0);
    }
    welded.triangles.push_back(corners);
  }
  scenes::add_normals(welded, 40);
  EXPECT_EQ(welded.positions.size(), 24u);
  for (const scenes::Vec3& n : welded.normals) EXPECT_EQ(std::abs(n.x) + std::abs(n.y) + std::abs(n.z), 1);
}

}  // namespace
}  // namespace capcon
