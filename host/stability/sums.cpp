#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "render/renderer.h"
#include "stability/checks.h"
#include "stability/scenes.h"

namespace capcon::stability {
namespace {

/// A scene all of whose pixels show one point, with the integral there in closed form.
struct KnownPoint {
  std::string name, what, scene;
  std::function<Job(std::uint32_t samples)> job;
  double value;
};

/// Beside a wall of height 1 and length 2 b at distance 1, twice the form factor of a perpendicular rectangle
/// from a point below its corner is hidden: (atan(b) - atan(b / sqrt(2)) / sqrt(2)) / pi (Howell's catalogue,
/// B-4).
KnownPoint beside_a_wall(int width, int height) {
  const double half_length = 8, root = std::sqrt(0.5);
  return {"ao-sums", "occlusion beside a wall",
          camera({-.5, -.8, .9}, {0, 0, 0}, 1e-7, {}, {0, 0, 1}, width, height) +
              world(matte(.5) + parallelogram({-8, -8, 0}, {16, 0, 0}, {0, 16, 0}) +
                    parallelogram({1, -half_length, 0}, {0, 2 * half_length, 0}, {0, 0, 1})),
          [](std::uint32_t samples) {
            AmbientOcclusionJob job;
            job.sampler = "random";
            job.samples = samples;
            return job;
          },
          1 - (std::atan(half_length) - root * std::atan(root * half_length)) / M_PI};
}

/// Under a disk of radius 1 at height 2: albedo L R^2 / (R^2 + h^2).
KnownPoint under_a_disk(int width, int height) {
  return {"direct-sums", "direct light under a disk",
          camera({-.5, -.8, .9}, {0, 0, 0}, 1e-7, {}, {0, 0, 1}, width, height) +
              world(matte(.5) + parallelogram({-8, -8, 0}, {16, 0, 0}, {0, 16, 0}) +
                    lamp("Translate 0 0 2 Scale 1 1 -1\nShape \"disk\" \"float radius\" 1\n", 3)),
          [](std::uint32_t samples) {
            DirectLightingJob job;
            job.sampler = "random";
            job.integrator_samples = samples;
            return job;
          },
          0.5 * 3 / 5.0};
}

Check run(const KnownPoint& known, const Workshop& workshop, int most) {
  const auto start = std::chrono::steady_clock::now();
  const ImageCase c{
      .group = "sums", .name = known.name, .what = known.what, .scene = known.scene, .job = known.job(1)};
  const Scene scene = read_case(c, workshop);
  Renderer renderer(scene, renderer_options(c.job, workshop));
  Check check;
  check.group = "sums";
  check.name = known.name;
  check.what = fmt::format("{}, 2^4 ... 2^{} samples a pixel", known.what, most);
  check.bound = "finite; RMSE sqrt(n) from 1/2 to 2 of its mean";
  check.reason =
      "sums are kept with what rounding took from them, counts are integers: the error falls to the end";
  std::vector<double> scaled;  // RMSE sqrt(n)
  double last = 0;
  for (int power = 4; power <= most; power += 4) {
    const std::uint32_t samples = 1u << power;
    const Image image = renderer.render(known.job(samples)).image;
    double squares = 0;
    const std::size_t pixels = image.pixels.size() / image.channels;
    for (std::size_t p = 0; p < pixels; ++p) {
      const double v = image.pixels[p * image.channels];
      ++check.values;
      if (!std::isfinite(v)) ++check.non_finite;
      squares += (v - known.value) * (v - known.value);
    }
    last = std::sqrt(squares / static_cast<double>(pixels));
    check.curve.emplace_back(samples, last);
    scaled.push_back(last * std::sqrt(static_cast<double>(samples)));
  }
  double log_mean = 0;
  for (const double s : scaled) log_mean += std::log(s) / static_cast<double>(scaled.size());
  double low = 1, high = 1;
  for (const double s : scaled) {
    low = std::min(low, s / std::exp(log_mean));
    high = std::max(high, s / std::exp(log_mean));
  }
  check.largest = last / known.value;
  check.measured =
      fmt::format("RMSE {:.1e} at the end; RMSE sqrt(n) {:.2f} ... {:.2f} of its mean", last, low, high);
  check.passed = check.non_finite == 0 && low > 0.5 && high < 2;
  check.command = command_of(path_of(c, workshop), known.job(1u << most));
  check.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return check;
}

}  // namespace

std::vector<Task> sum_tasks(const Workshop& workshop, int most) {
  std::vector<Task> tasks;
  for (const KnownPoint& known : {beside_a_wall(8, 4), under_a_disk(4, 4)})
    tasks.push_back({"sums", known.name, [=] { return run(known, workshop, most); }});
  return tasks;
}

}  // namespace capcon::stability
