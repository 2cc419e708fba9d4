#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/statistics.h"
#include "render/renderer.h"
#include "scene/scene.h"

namespace capcon {

struct TracerBenchOptions {
  RendererOptions renderer;
  double radius = 1e30;        ///< of the occlusion rays
  std::uint32_t samples = 16;  ///< occlusion rays a pixel, random cosine-weighted directions
  std::uint32_t repeats = 7;
};

/// Rays of one kind, cast in turn by everybody, repeat by repeat.
struct TracerBenchRow {
  std::string rays;    ///< "primary" or "occlusion"
  std::string tracer;  ///< "capcon", "embree single", "embree wide", "embree stream"
  std::size_t count = 0;
  std::vector<double> cpu_seconds;     ///< of each repeat, all threads
  std::vector<double> device_seconds;  ///< capcon only, wall time by the device's timestamps
  std::vector<double> ratios;          ///< of rays a CPU second beside embree single's, repeat by repeat
  std::size_t different = 0;           ///< rays whose answer differs from embree single's
  std::size_t ties = 0;  ///< of these, same distance to 1e-5 relative, or met within 1e-5 of an edge or end
};

struct TracerBench {
  std::vector<TracerBenchRow> rows;
  std::uint64_t triangles = 0;
  std::uint64_t left_out = 0;  ///< spheres and disks, instances counted
  double build_seconds = 0, embree_build_seconds = 0;
  double bytes_per_triangle = 0;
  double compile_seconds = 0;
  std::string device;
};

/// Median of values.
double median(std::vector<double> values);

/// Without the scene's spheres and disks, which Embree does not have. InputError when nothing else is there.
TracerBench bench_tracer(const Scene& scene, const TracerBenchOptions& options,
                         const std::function<void(double)>& on_progress);

}  // namespace capcon
