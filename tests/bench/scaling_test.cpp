#include "bench/scaling_bench.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "bench/embree_tracer.h"

namespace capcon {
namespace {

TracerBenchOptions small_bench() {
  TracerBenchOptions options;
  options.renderer.device = "lavapipe";
  options.samples = 2;
  options.repeats = 1;
  return options;
}

// The same surface at every size: its vertices lie on those of a finer one.
TEST(Scaling, TheSurfaceIsTheSameAtEverySize) {
  const Scene coarse = hilly_square(2 * 20 * 20, 8, 8), fine = hilly_square(2 * 40 * 40, 8, 8);
  ASSERT_EQ(coarse.meshes[0].triangles.size(), 800u);
  ASSERT_EQ(fine.meshes[0].triangles.size(), 3200u);
  for (int j = 0; j <= 20; ++j) {
    for (int i = 0; i <= 20; ++i) {
      EXPECT_EQ(coarse.meshes[0].positions[j * 21 + i], fine.meshes[0].positions[2 * j * 41 + 2 * i]);
    }
  }
  EXPECT_LE(hilly_square(10000, 8, 8).instanced_triangles(), 10000u);
}

TEST(Scaling, GrowthIsTheGeometricMean) {
  std::vector<ScalingPoint> points(3);
  for (int k = 0; k < 3; ++k) {
    points[k].triangles = static_cast<std::uint64_t>(std::pow(10, 4 + k));
    points[k].capcon.primary = 100 * std::pow(1.3, k);
  }
  points[1].capcon.primary = 7;  // what lies between does not count
  const auto cost = [](const ScalingPoint& p) { return p.capcon.primary; };
  EXPECT_NEAR(growth_per_tenfold(points, cost), 1.3, 1e-12);
  EXPECT_EQ(growth_per_tenfold({points[0]}, cost), 1);
}

TEST(TracerBench, MeetsWhatEmbreeMeets) {
  if (!EmbreeTracer::available()) GTEST_SKIP();
  const TracerBench bench = bench_tracer(hilly_square(20000, 64, 64), small_bench(), [](double) {});
  ASSERT_EQ(bench.rows.size(), 8u);
  for (const TracerBenchRow& row : bench.rows) {
    if (row.tracer != "capcon") continue;
    EXPECT_GT(row.count, 3000u) << row.rays;
    EXPECT_LE(row.different, 3u) << row.rays;  // rays within rounding of an edge
    EXPECT_EQ(row.ratios.size(), 1u);
  }
}

TEST(TracerBench, LeavesSpheresAndDisksOutOnBothSides) {
  Scene scene = hilly_square(2000, 32, 32);
  Shape sphere;
  sphere.kind = ShapeKind::sphere;
  sphere.radius = 0.5;
  scene.shapes.push_back(sphere);
  Object object;
  sphere.kind = ShapeKind::disk;
  object.shapes.push_back(sphere);
  scene.objects.push_back(object);
  scene.instances = {{0, glm::dmat4(1)}, {0, glm::dmat4(2)}};
  const TracerBench bench = bench_tracer(scene, small_bench(), [](double) {});
  EXPECT_EQ(bench.left_out, 3u);
  for (const TracerBenchRow& row : bench.rows) {
    if (row.rays == "primary") { EXPECT_LE(row.different, 2u) << row.tracer; }
  }
  scene.shapes.erase(scene.shapes.begin());
  EXPECT_THROW(bench_tracer(scene, small_bench(), [](double) {}), InputError);
}

}  // namespace
}  // namespace capcon
