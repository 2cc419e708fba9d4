// What samplers err in images, beside sobol-owen, over seeds, with 95 % intervals:
//   study_bench SCENE JOB WIDTH SAMPLES[,SAMPLES...] SEEDS [samplers...]
// JOB: ao:RADIUS, direct (1xN at pixel centres), split:P (P image samples, N in all, each at its own place),
// igi (1 set of N paths). WIDTH: of the image, 0 for the scene's. Three figures a sampler: the mean squared
// error of a pixel, the same without the worst hundredth (where a few glints carry the mean), and that of
// the image behind a Gaussian of sigma 1 pixel, as an eye that does not see pixels has it. Truth: the mean of
// images of capcon-domain with other seeds.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "render/features.h"
#include "render/renderer.h"
#include "sampling/sampler.h"

using namespace capcon;

namespace {

struct Kind {
  std::string name;
  double value = 0;
};

Kind parse_kind(const std::string& text) {
  const auto colon = text.find(':');
  if (colon == std::string::npos) return {text, 0};
  return {text.substr(0, colon), std::strtod(text.c_str() + colon + 1, nullptr)};
}

Job job_of(const Kind& kind, const std::string& sampler, std::uint32_t samples, std::uint32_t seed) {
  if (kind.name == "ao") {
    AmbientOcclusionJob job;
    job.sampler = sampler, job.samples = samples, job.seed = seed, job.radius = kind.value;
    return job;
  }
  DirectLightingJob direct;
  direct.sampler = sampler, direct.integrator_samples = samples, direct.seed = seed;
  if (kind.name == "split") {
    direct.image_samples = std::max(1u, static_cast<std::uint32_t>(kind.value));
    direct.integrator_samples = std::max(1u, samples / direct.image_samples);
    direct.position = PixelPosition::jittered;
  }
  if (kind.name != "igi") return direct;
  GlobalIlluminationJob job;
  job.direct = direct, job.direct.integrator_samples = 1;
  job.sampler = sampler, job.paths = samples, job.sets = 1;
  return job;
}

std::vector<double> values(const Image& image) {
  return {image.pixels.begin(), image.pixels.end()};
}

/// A Gaussian of sigma 1 pixel, cut off at 4 and where the image ends.
std::vector<double> blurred(const std::vector<double>& values, int width, int height, int channels) {
  const auto along = [&](const std::vector<double>& in, int dx, int dy) {
    std::vector<double> out(in.size());
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (int c = 0; c < channels; ++c) {
          double sum = 0, weights = 0;
          for (int k = -4; k <= 4; ++k) {
            const int u = x + k * dx, v = y + k * dy;
            if (u < 0 || v < 0 || u >= width || v >= height) continue;
            const double weight = std::exp(-k * k / 2.0);
            sum += weight * in[(std::size_t(v) * width + u) * channels + c];
            weights += weight;
          }
          out[(std::size_t(y) * width + x) * channels + c] = sum / weights;
        }
    return out;
  };
  return along(along(values, 1, 0), 0, 1);
}

double mean_square(const std::vector<double>& errors) {
  double sum = 0;
  for (const double e : errors) sum += e * e;
  return sum / static_cast<double>(errors.size());
}

/// Without the worst hundredth.
double trimmed(const std::vector<double>& errors) {
  std::vector<double> squares;
  for (const double e : errors) squares.push_back(e * e);
  const auto kept = static_cast<std::ptrdiff_t>(squares.size() - squares.size() / 100);
  std::nth_element(squares.begin(), squares.begin() + kept - 1, squares.end());
  return std::accumulate(squares.begin(), squares.begin() + kept, 0.0) / static_cast<double>(kept);
}

/// Ratio of means over seeds, with the jackknife's interval.
std::string ratio(const std::vector<double>& above, const std::vector<double>& below) {
  const std::size_t n = above.size();
  double a = 0, b = 0, squares = 0;
  for (std::size_t i = 0; i < n; ++i) a += above[i], b += below[i];
  for (std::size_t i = 0; i < n; ++i) {
    const double without = (a - above[i]) / (b - below[i]) - a / b;
    squares += without * without;
  }
  const double student = n >= 20 ? 2.09 : n >= 10 ? 2.26 : 2.78;
  return fmt::format("{:.3f} +- {:.3f}", a / b, student * std::sqrt(squares * double(n - 1) / double(n)));
}

}  // namespace

int main(int count, char** words) {
  if (count < 6) {
    fmt::print(stderr,
               "study_bench SCENE ao:RADIUS|direct|split:P|igi WIDTH SAMPLES[,...] SEEDS [samplers...]\n");
    return 2;
  }
  const Kind kind = parse_kind(words[2]);
  Scene scene = read_scene(words[1], needed_reading(job_of(kind, "random", 1, 1), false));
  if (const int width = std::atoi(words[3]); width > 0) {
    scene.film.height = std::max(1, scene.film.height * width / scene.film.width);
    scene.film.width = width;
  }
  const auto seeds = static_cast<std::uint32_t>(std::atoi(words[5]));
  std::vector<std::string> samplers(words + 6, words + count);
  if (samplers.empty()) samplers = {"pmj02", "sobol-z", "capcon-domain", "capcon-screen"};
  RendererOptions options;
  options.shading = kind.name != "ao";
  Renderer renderer(scene, options);
  std::vector<double> truth;
  const std::uint32_t truths = kind.name == "igi" ? 64 : 4;
  for (std::uint32_t k = 0; k < truths; ++k) {
    const auto image = values(renderer.render(job_of(kind, "capcon-domain", 1024, 1000 + k)).image);
    truth.resize(image.size());
    for (std::size_t i = 0; i < image.size(); ++i) truth[i] += image[i] / truths;
  }
  const int width = scene.film.width, height = scene.film.height,
            channels = static_cast<int>(truth.size() / (std::size_t(width) * height));
  for (const char* n = words[4]; n != nullptr && *n != 0;) {
    char* end = nullptr;
    const auto samples = static_cast<std::uint32_t>(std::strtoul(n, &end, 10));
    n = *end == ',' ? end + 1 : nullptr;
    std::map<std::string, std::vector<double>> plain, most, soft;
    std::vector<std::string> all = samplers;
    all.insert(all.begin(), "sobol-owen");
    for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
      for (const std::string& sampler : all) {
        auto errors = values(renderer.render(job_of(kind, sampler, samples, seed)).image);
        for (std::size_t i = 0; i < errors.size(); ++i) errors[i] -= truth[i];
        plain[sampler].push_back(mean_square(errors));
        most[sampler].push_back(trimmed(errors));
        soft[sampler].push_back(mean_square(blurred(errors, width, height, channels)));
      }
    }
    for (const std::string& sampler : all) {
      fmt::print("{:4} {:14}", samples, sampler);
      for (auto& [name, errors] : {std::pair("MSE", &plain), {"trimmed", &most}, {"filtered", &soft}}) {
        const std::vector<double>& of = (*errors)[sampler];
        fmt::print("  {} {:.3e}  {}", name, std::accumulate(of.begin(), of.end(), 0.0) / seeds,
                   ratio(of, (*errors)["sobol-owen"]));
      }
      fmt::print("\n");
      std::fflush(stdout);
    }
  }
}
