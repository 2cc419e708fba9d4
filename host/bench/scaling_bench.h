#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/tracer_bench.h"

namespace capcon {

/// Nanoseconds of CPU time a ray.
struct RayCosts {
  double primary = 0, occlusion = 0;
};

/// One size of the scaling bench.
struct ScalingPoint {
  std::uint64_t triangles = 0;
  double build_seconds = 0;  ///< wall time of the tree
  double bytes_per_triangle = 0;
  RayCosts capcon, embree;  ///< embree: its single calls; zero where the build has no Embree
};

/// One surface in more and more triangles.
struct ScalingSeries {
  std::string name;  ///< "finer": all its own; "instances": of one patch of 10^4, with two levels
  std::vector<ScalingPoint> points;
};

/// A hilly square with hills of all sizes, seen from above its edge: the same surface in `triangles`
/// triangles or a few less.
Scene hilly_square(std::uint64_t triangles, int width, int height);

/// The same square covered by instances of one such surface of 10^4 triangles or a few less, turned by
/// quarters and a little too large, so that they overlap: as many a side as `triangles` has room for, at
/// least one.
Scene patched_square(std::uint64_t triangles, int width, int height);

/// Costs at 10^4 triangles, 10^5 and so on up to `largest`, with the same camera: "finer", then "instances".
/// The options' `instancing` is not used.
std::vector<ScalingSeries> bench_scaling(const TracerBenchOptions& options, std::uint64_t largest, int width,
                                         int height, const std::function<void(double)>& on_progress);

/// By what the cost grows for ten times the triangles: geometric mean from the first point to the last. 1 for
/// fewer than two.
double growth_per_tenfold(const std::vector<ScalingPoint>& points,
                          const std::function<double(const ScalingPoint&)>& cost);

}  // namespace capcon
