#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "image/image.h"

namespace capcon {

/// Where in a pixel its image samples lie.
enum class PixelPosition : std::uint8_t {
  centre,   ///< all at the pixel's centre: shows the integrator's error alone
  jittered  ///< each sample at a point of the sampler's own 2D set over the pixel (box filter)
};

/// Share number `index` of `count` of a job's samples, for processes that make one image together. Shares are
/// runs of consecutive samples; together they are all of them, each once.
struct SampleShare {
  std::uint32_t index = 0;  ///< below count
  std::uint32_t count = 1;

  bool whole() const { return count == 1; }
  /// The share of `n` samples: first, and the one after the last. Empty where there are fewer than shares.
  std::pair<std::uint32_t, std::uint32_t> of(std::uint32_t n) const {
    const auto cut = [&](std::uint64_t i) { return static_cast<std::uint32_t>(n * i / count); };
    return {cut(index), cut(index + std::uint64_t(1))};
  }
};

/// One ambient-occlusion render, a plain value: the text's integral
/// A(x, n, r) = 1/pi integral over the hemisphere of V(x, w, r) |cos theta| dw, cosine-weighted by the
/// concentric map.
struct AmbientOcclusionJob {
  double radius = std::numeric_limits<double>::infinity();  ///< r > 0: occluders farther away do not count
  std::string sampler = "capcon";
  std::uint32_t samples = 16;  ///< occlusion rays a pixel, >= 1
  std::uint32_t seed = 1;
  PixelPosition position = PixelPosition::centre;
  SampleShare share = {};  ///< of the rays of a pixel
};

/// How a pixel weighs what lies around its centre; image samples are placed in proportion (no weights, no
/// sharing).
enum class PixelFilter : std::uint8_t {
  box,      ///< the pixel's own square
  gaussian  ///< pbrt-v4's: exp(-x^2 / (2 0.5^2)) less its value at 1.5, a radius of 1.5 pixels, in x and y
};

/// How light and BSDF samples are combined (Veach and Guibas, "Optimally Combining Sampling Techniques",
/// 1995).
enum class Strategy : std::uint8_t {
  power,    ///< p^2 / (p^2 + q^2)
  balance,  ///< p / (p + q)
  lights,   ///< light samples alone
  bsdf      ///< BSDF samples alone: point and distant lights give nothing
};

/// One direct-lighting render, a plain value: what a surface emits and reflects of the light that comes
/// straight from the lights. Each image sample has `integrator_samples` points on every light and as many for
/// the BSDF.
struct DirectLightingJob {
  std::string sampler = "capcon";
  std::uint32_t image_samples = 1;        ///< P >= 1
  std::uint32_t integrator_samples = 16;  ///< I >= 1
  std::uint32_t seed = 1;
  PixelPosition position = PixelPosition::centre;  ///< of image samples; `jittered`: by the filter
  PixelFilter filter = PixelFilter::box;
  Strategy strategy = Strategy::power;
  /// Whether the P sets of a pixel are parts of one set of P I points; else each is a set of its own.
  bool partition = true;
  /// Of the image samples; of the integrator's where all lie at the pixel's centre; of instant global
  /// illumination there also of the sets.
  SampleShare share = {};

  std::uint32_t samples() const { return image_samples * integrator_samples; }
};

/// What becomes of the geometry term G of a point and a virtual light, which grows without limit in corners.
enum class Clamping : std::uint8_t {
  none,       ///< as it is: unbiased, with bright spots
  clamp,      ///< at most the limit: too dark in corners
  compensate  ///< at most the limit, and what that leaves out by rays of their own: unbiased
};

/// One instant-global-illumination render, a plain value (docs/igi.md): direct lighting, and light that comes
/// by at least one surface from virtual point lights at the hits of light paths.
struct GlobalIlluminationJob {
  DirectLightingJob direct;        ///< all that happens in the pixel, and the seed of everything
  std::string sampler = "capcon";  ///< of light paths
  std::uint32_t paths = 128;       ///< N, light paths a set
  std::uint32_t sets = 4;          ///< S; a pixel uses all of them, or with blocks S / block^2
  /// Whether the sets are parts of one set of N S points; else each is a set of its own.
  bool partition = true;
  Clamping clamping = Clamping::compensate;
  double limit = 0;            ///< of G, in 1 / square scene unit; 0: default_geometry_limit() of the scene
  std::uint32_t gather = 1;    ///< compensation rays for each set that an image sample uses, >= 1
  std::uint32_t block = 1;     ///< interleaved sampling: pixels of block x block have sets of their own
  bool only_indirect = false;  ///< leave out what comes straight from lights
  /// VPLs shine to both sides of their surface, as those of pbrt-v2 do, so that light leaks through thin
  /// walls: for comparisons with it.
  bool two_sided = false;

  /// Sets that a pixel uses.
  std::uint32_t sets_a_pixel() const { return sets / (block * block); }
};

/// One render by unidirectional path tracing with next-event estimation, with independent random numbers:
/// what others are checked with. The reference alone knows it.
struct PathTracingJob {
  std::uint32_t samples = 64;  ///< paths a pixel, >= 1
  std::uint32_t seed = 1;
  PixelPosition position = PixelPosition::centre;  ///< `jittered`: evenly in the pixel
  bool only_indirect = false;                      ///< leave out what comes straight from lights
};

/// Any render.
using Job = std::variant<AmbientOcclusionJob, DirectLightingJob, GlobalIlluminationJob, PathTracingJob>;

/// Whether a job can be shared: all but path tracing.
bool can_be_shared(const Job& job);
/// The same job with this share of its samples.
Job with_share(Job job, const SampleShare& share);

/// Where the image samples of a job lie.
PixelPosition position_of(const Job& job);
/// InputError where its numbers make no sense together.
void check_job(const GlobalIlluminationJob& job);
/// Whether it needs materials and lights.
bool needs_shading(const Job& job);

/// Seconds by stage (read build upload compile points primary occlusion resolve write ...): wall time, and on
/// a Vulkan device the time between its own timestamps.
struct Timings {
  std::map<std::string, double> wall;
  std::map<std::string, double> device;
};

nlohmann::json to_json(const Timings& timings);

/// What a render hands back.
struct RenderResult {
  /// Ambient occlusion: one channel in [0, 1], 0 where no surface is seen. Else radiance, linear sRGB.
  Image image;
  /// Of a share of a job: for each value of the image the sum over the share's samples. Those of all shares,
  /// added up and divided by `samples`, are the image, which is black meanwhile.
  std::vector<double> sums;
  std::uint32_t samples = 0;  ///< of the whole job, a pixel, where there are sums
  Timings timings;
  std::uint64_t rays = 0;            ///< occlusion or shadow rays traced
  std::uint64_t virtual_lights = 0;  ///< of instant global illumination
  std::string device;                ///< the device's own name, or "reference"
  /// When the first kernel that traces was handed to the device; the clock's zero where there is none.
  std::chrono::steady_clock::time_point first_dispatch{};
};

/// Makes the image of a result whose sums are those of all shares.
void finish_shares(RenderResult& all);

}  // namespace capcon
