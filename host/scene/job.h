#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "image/image.h"

namespace capcon {

/// Where in a pixel its image samples lie.
enum class PixelPosition : std::uint8_t {
  centre,   ///< all at the pixel's centre: shows the integrator's error alone
  jittered  ///< each sample at a point of the sampler's own 2D set over the pixel (box filter)
};

/// One ambient-occlusion render, a plain value: the text's integral
/// A(x, n, r) = 1/pi integral over the hemisphere of V(x, w, r) |cos theta| dw, cosine-weighted by the concentric map.
struct AmbientOcclusionJob {
  double radius = std::numeric_limits<double>::infinity();  ///< r > 0: occluders farther away do not count
  std::string sampler = "capcon";
  std::uint32_t samples = 16;  ///< occlusion rays a pixel, >= 1
  std::uint32_t seed = 1;
  PixelPosition position = PixelPosition::centre;
};

/// Seconds by stage (read build upload compile points primary occlusion resolve write ...): wall time, and on a Vulkan
/// device the time between its own timestamps.
struct Timings {
  std::map<std::string, double> wall;
  std::map<std::string, double> device;
};

nlohmann::json to_json(const Timings& timings);

/// What a render hands back.
struct RenderResult {
  Image image;  ///< one channel: ambient occlusion in [0, 1]; 0 where no surface is seen
  Timings timings;
  std::uint64_t rays = 0;  ///< occlusion rays traced
  std::string device;      ///< the device's own name, or "reference"
  /// When the first kernel that traces was handed to the device; the clock's zero where there is none.
  std::chrono::steady_clock::time_point first_dispatch{};
};

}  // namespace capcon
