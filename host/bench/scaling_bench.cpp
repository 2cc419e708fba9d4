#include "bench/scaling_bench.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

namespace capcon {
namespace {

/// Seven octaves of waves, each half as high and about twice as fine as the one before.
double height_at(double x, double y) {
  double height = 0, amplitude = 0.12, frequency = 3;
  for (int octave = 0; octave < 7; ++octave) {
    height +=
        amplitude * std::sin(frequency * x + 1.3 * octave) * std::cos(1.1 * frequency * y + 2.1 * octave);
    amplitude *= 0.5;
    frequency *= 2.03;
  }
  return height;
}

double nanoseconds(const TracerBench& bench, const char* rays, const char* tracer) {
  for (const TracerBenchRow& row : bench.rows) {
    if (row.rays == rays && row.tracer == tracer)
      return 1e9 * median(row.cpu_seconds) / static_cast<double>(row.count);
  }
  return 0;
}

}  // namespace

Scene hilly_square(std::uint64_t triangles, int width, int height) {
  const auto side =
      static_cast<std::uint32_t>(std::max(1.0, std::floor(std::sqrt(static_cast<double>(triangles) / 2))));
  TriangleMesh mesh;
  mesh.positions.reserve(std::size_t(side + 1) * (side + 1));
  mesh.triangles.reserve(2 * std::size_t(side) * side);
  for (std::uint32_t j = 0; j <= side; ++j) {
    for (std::uint32_t i = 0; i <= side; ++i) {
      const double x = 2.0 * i / side - 1, y = 2.0 * j / side - 1;
      mesh.positions.emplace_back(x, height_at(x, y), y);
    }
  }
  for (std::uint32_t j = 0; j < side; ++j) {
    for (std::uint32_t i = 0; i < side; ++i) {
      const std::uint32_t a = j * (side + 1) + i, c = a + side + 1;
      mesh.triangles.emplace_back(a, a + 1, c + 1);
      mesh.triangles.emplace_back(a, c + 1, c);
    }
  }
  Scene scene;
  scene.name = "hilly square";
  scene.film = {width, height, ""};
  scene.camera.camera_to_world = glm::translate(glm::dmat4(1), glm::dvec3(0, 1.2, -1.2));
  scene.camera.camera_to_world = glm::rotate(scene.camera.camera_to_world, M_PI / 4, glm::dvec3(1, 0, 0));
  scene.camera.fov_degrees = 60;
  scene.meshes.push_back(std::move(mesh));
  Shape shape;
  shape.mesh = 0;
  scene.shapes.push_back(shape);
  return scene;
}

Scene patched_square(std::uint64_t triangles, int width, int height) {
  constexpr std::uint64_t kPatch = 10000;
  constexpr double kOverlap = 1.1;
  Scene scene = hilly_square(kPatch, width, height);
  scene.objects.emplace_back().shapes = std::move(scene.shapes);
  scene.shapes.clear();
  const auto side = static_cast<int>(
      std::max(1.0, std::floor(std::sqrt(static_cast<double>(triangles) / static_cast<double>(kPatch)))));
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const glm::dvec3 centre((2.0 * i + 1) / side - 1, 0, (2.0 * j + 1) / side - 1);
      glm::dmat4 m = glm::translate(glm::dmat4(1), centre);
      m = glm::rotate(m, 0.5 * M_PI * ((3 * i + 5 * j + i * j) % 4), glm::dvec3(0, 1, 0));
      scene.instances.push_back({0, glm::scale(m, glm::dvec3((side > 1 ? kOverlap : 1.0) / side))});
    }
  }
  return scene;
}

std::vector<ScalingSeries> bench_scaling(const TracerBenchOptions& options, std::uint64_t largest, int width,
                                         int height, const std::function<void(double)>& on_progress) {
  // Progress by the surfaces' share of all triangles: the largest take nearly all the time.
  constexpr double kFiner = 0.8;
  std::vector<ScalingSeries> series;
  for (const bool instances : {false, true}) {
    TracerBenchOptions own = options;
    own.renderer.instancing = instances ? "two-level" : "flat";
    ScalingSeries& one = series.emplace_back(ScalingSeries{instances ? "instances" : "finer", {}});
    for (std::uint64_t size = 10000; size <= largest; size *= 10) {
      const double before = static_cast<double>(size) / 10 / static_cast<double>(largest);
      const auto share = [&](double f) {
        const double done = before + f * 9 * before;
        on_progress(instances ? kFiner + (1 - kFiner) * done : kFiner * done);
      };
      const Scene scene = instances ? patched_square(size, width, height) : hilly_square(size, width, height);
      const TracerBench bench = bench_tracer(scene, own, share);
      ScalingPoint point;
      point.triangles = bench.triangles;
      point.build_seconds = bench.build_seconds;
      point.bytes_per_triangle = bench.bytes_per_triangle;
      point.capcon = {nanoseconds(bench, "primary", "capcon"), nanoseconds(bench, "occlusion", "capcon")};
      point.embree = {nanoseconds(bench, "primary", "embree single"),
                      nanoseconds(bench, "occlusion", "embree single")};
      one.points.push_back(point);
    }
  }
  return series;
}

double growth_per_tenfold(const std::vector<ScalingPoint>& points,
                          const std::function<double(const ScalingPoint&)>& cost) {
  if (points.size() < 2) return 1;
  const double tenfolds = std::log10(static_cast<double>(points.back().triangles) /
                                     static_cast<double>(points.front().triangles));
  return std::pow(cost(points.back()) / cost(points.front()), 1 / tenfolds);
}

}  // namespace capcon
