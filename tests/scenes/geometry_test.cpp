// The generator's meshes as files: sound, small, and the same on every run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>

#include "base/file.h"
#include "generator/courtyard.h"
#include "generator/nave.h"
#include "generator/ply.h"

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
  EXPECT_EQ(bytes.size(), at + 12 * ply.points.size() + 13 * ply.triangles.size());
  std::memcpy(ply.points.data(), bytes.data() + at, 12 * ply.points.size());
  at += 12 * ply.points.size();
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
    scenes::courtyard(1).write(folder->path);
    scenes::nave().write(folder->path);
  }
  const auto a = files_of(first.path), b = files_of(second.path);
  EXPECT_GT(a.size(), 50u);
  EXPECT_TRUE(a == b);
  std::size_t bytes = 0;
  for (const auto& [name, content] : a) bytes += content.size();
  EXPECT_LT(bytes, 20u << 20);
}

TEST(Geometry, TriangleCountsAreAsDocumented) {
  const scenes::Assembly court = scenes::courtyard(1), nave = scenes::nave();
  EXPECT_THAT(court.unique_triangles(), testing::AllOf(testing::Ge(60'000u), testing::Le(150'000u)));
  EXPECT_GE(court.instanced_triangles(), 300'000u);
  EXPECT_THAT(nave.instanced_triangles(), testing::AllOf(testing::Ge(80'000u), testing::Le(150'000u)));
  const scenes::Assembly four = scenes::courtyard(2);
  EXPECT_EQ(four.unique_triangles(), court.unique_triangles());
  EXPECT_EQ(four.instanced_triangles(), 4 * court.instanced_triangles());
}

class EveryMesh : public testing::TestWithParam<const char*> {
 protected:
  scenes::Assembly scene() const {
    return GetParam() == std::string("nave") ? scenes::nave() : scenes::courtyard(1);
  }
};
INSTANTIATE_TEST_SUITE_P(Of, EveryMesh, testing::Values("courtyard", "nave"),
                         [](const auto& info) { return info.param; });

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

}  // namespace
}  // namespace capcon
