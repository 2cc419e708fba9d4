#include "bench/scaling_bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "base/error.h"
#include "bench/embree_tracer.h"
#include "bench/geometry_triangles.h"

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

TEST(Scaling, PatchesCoverTheSquare) {
  const Scene scene = patched_square(100000, 8, 8);
  ASSERT_EQ(scene.instances.size(), 9u);
  EXPECT_EQ(patched_square(10000, 8, 8).instances.size(), 1u);
  glm::dvec3 low(1e9), high(-1e9);
  double area = 0;
  for (const Instance& instance : scene.instances) {
    glm::dvec3 own_low(1e9), own_high(-1e9);
    for (const glm::dvec3 corner : {glm::dvec3(-1, 0, -1), glm::dvec3(1, 0, 1)}) {
      const glm::dvec3 p(instance.to_world * glm::dvec4(corner, 1));
      own_low = glm::min(own_low, p), own_high = glm::max(own_high, p);
    }
    low = glm::min(low, own_low), high = glm::max(high, own_high);
    area += (own_high.x - own_low.x) * (own_high.z - own_low.z);
  }
  EXPECT_NEAR(high.x - low.x, 2 + 0.1 * 2 / 3, 1e-9);
  EXPECT_NEAR(high.z - low.z, 2 + 0.1 * 2 / 3, 1e-9);
  EXPECT_NEAR(area, 1.21 * 4, 1e-9);
}

TEST(Scaling, BothSeriesAreMeasured) {
  const auto series = bench_scaling(small_bench(), 100000, 32, 32, [](double f) { EXPECT_LE(f, 1.0); });
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(series[0].name, "finer");
  EXPECT_EQ(series[1].name, "instances");
  for (const ScalingSeries& one : series) {
    ASSERT_EQ(one.points.size(), 2u);
    for (const ScalingPoint& point : one.points) {
      EXPECT_GT(point.capcon.primary, 0);
      EXPECT_GT(point.capcon.occlusion, 0);
    }
  }
  EXPECT_EQ(series[1].points[1].triangles, 9 * series[1].points[0].triangles);
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

/// A hill of its own, and turned, mirrored and stretched instances of two objects.
Scene instanced_hills() {
  Scene scene = hilly_square(2000, 64, 64);
  scene.meshes.push_back(hilly_square(800, 8, 8).meshes[0]);
  for (std::uint32_t mesh : {0u, 1u}) {
    Object object;
    object.shapes = {scene.shapes[0], scene.shapes[0]};
    object.shapes[0].mesh = object.shapes[1].mesh = mesh;
    object.shapes[1].to_world = glm::translate(glm::dmat4(1), glm::dvec3(0.3, 0.2, 0.1));
    scene.objects.push_back(object);
  }
  for (int i = 0; i < 12; ++i) {
    glm::dmat4 m =
        glm::translate(glm::dmat4(1), glm::dvec3(0.3 * (i % 4) - 0.5, 0.1 + 0.02 * i, 0.4 * (i / 4) - 0.4));
    m = glm::rotate(m, 0.7 * i, glm::normalize(glm::dvec3(0.2, 1, 0.1 * i)));
    m = glm::scale(m, glm::dvec3(i % 3 == 0 ? -0.2 : 0.2, 0.1 + 0.02 * i, 0.15));
    scene.instances.push_back({static_cast<std::uint32_t>(i % 2), m});
  }
  return scene;
}

TEST(TracerBench, MeetsWhatEmbreeMeetsInInstances) {
  if (!EmbreeTracer::available()) GTEST_SKIP() << "this build has no Embree";
  TracerBenchOptions options = small_bench();
  for (const char* instancing : {"flat", "two-level"}) {
    options.renderer.instancing = instancing;
    const TracerBench bench = bench_tracer(instanced_hills(), options, [](double) {});
    EXPECT_EQ(bench.triangles, 1922u + 6 * (2 * 1922u + 2 * 800u));
    for (const TracerBenchRow& row : bench.rows) {
      if (row.rays == "primary") {
        EXPECT_GT(row.count, 3000u);
      }
      EXPECT_LE(row.different, 6u) << instancing << " " << row.rays << " " << row.tracer;
    }
  }
}

TEST(TracerBench, TrianglesAreFoundByTheirIdsWithOneLevelAndTwo) {
  const Scene scene = instanced_hills();
  const Geometry flat = build_geometry(scene);
  const Geometry levels = build_geometry(scene, {.two_level = true, .keep_instances = true});
  ASSERT_EQ(flat.triangle_count, levels.triangle_count);
  ASSERT_EQ(levels.instance_count(), 13u);
  const TriangleLookup in_flat(flat), in_levels(levels);
  for (std::uint32_t id = 0; id < flat.triangle_count; ++id) {
    const auto a = in_flat.vertices(id), b = in_levels.vertices(id);
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(glm::distance(a[k], b[k]), 0, 1e-6) << id;
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
    if (row.rays == "primary") {
      EXPECT_LE(row.different, 2u) << row.tracer;
    }
  }
  scene.shapes.erase(scene.shapes.begin());
  EXPECT_THROW(bench_tracer(scene, small_bench(), [](double) {}), InputError);
}

}  // namespace
}  // namespace capcon
