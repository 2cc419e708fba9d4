// sampling_bench [sets, default 10,000,000] [sampler, default capcon-domain]
//     Whether a sampler is unbiased, to a thousandth of one set's error: mean error over many pixels' sets
//     beside the root mean square error of one, on the disk; |mean| should stay below 3 / sqrt(sets) of it.
// sampling_bench times [samplers, default all]
//     Seconds until sets as large as those of light paths are there.
// sampling_bench spacing [samplers, default all]
//     How even such sets and their parts are on the torus.

#include <fmt/format.h>

#include <cctype>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "points/ensemble.h"
#include "points/spread_partition.h"
#include "sampling/sampler.h"

namespace {

using namespace capcon;

struct Integrand {
  const char* name;
  std::function<double(glm::dvec2)> f;
  double mean;  ///< over the unit disk
};

/// Share of the disk beyond a line at distance d of its centre.
double segment(double d) {
  return (std::acos(d) - d * std::sqrt(1 - d * d)) / std::numbers::pi;
}

const std::vector<Integrand>& integrands() {
  static const std::vector<Integrand> all = {
      {"x^2", [](glm::dvec2 p) { return p.x * p.x; }, 0.25},
      {"1 + x + x y + y^4", [](glm::dvec2 p) { return 1 + p.x + p.x * p.y + p.y * p.y * p.y * p.y; }, 1.125},
      {"half-plane x > 0.3", [](glm::dvec2 p) { return p.x > 0.3 ? 1.0 : 0.0; }, segment(0.3)},
      {"half-plane, turned", [](glm::dvec2 p) { return 0.6 * p.x + 0.8 * p.y > -0.55 ? 1.0 : 0.0; },
       1 - segment(0.55)},
      {"blocker, radius 0.3", [](glm::dvec2 p) { return std::hypot(p.x - 0.2, p.y + 0.4) < 0.3 ? 0.0 : 1.0; },
       0.91},
      {"small blocker", [](glm::dvec2 p) { return std::hypot(p.x + 0.7, p.y - 0.1) < 0.05 ? 0.0 : 1.0; },
       0.9975},
  };
  return all;
}

struct Size {
  std::uint32_t count, parts;
};

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void print_times(const std::vector<std::string>& samplers) {
  fmt::print("seconds of make_sampler / tables(), all domains; {} threads\n", thread_count());
  for (const std::string& name : samplers) {
    fmt::print("{:14}", name);
    for (const Size s :
         {Size{128, 1}, Size{384, 3}, Size{512, 4}, Size{1000, 8}, Size{2048, 16}, Size{4096, 32}}) {
      std::unique_ptr<Sampler> sampler;
      const double made = seconds_of([&] { sampler = make_sampler(name, s.count, 1, s.parts); });
      const double tables = seconds_of([&] { sampler->tables(); });
      fmt::print("  {}/{} {:.3f}/{:.3f}", s.count, s.parts, made, tables);
      std::fflush(stdout);
    }
    fmt::print("\n");
  }
}

void print_spacing(const std::vector<std::string>& samplers) {
  constexpr std::uint32_t kPixels = 8;
  fmt::print("mean distance to the nearest point over the hexagonal lattice's, torus, {} pixels\n", kPixels);
  for (const std::uint32_t parts : {4u, 16u}) {
    for (const std::string& name : samplers) {
      const auto sampler = make_sampler(name, 128 * parts, 1, parts);
      SubsetSpacing part{0, 1e300}, whole{0, 1e300};
      std::vector<std::uint32_t> labels(sampler->count()), one(sampler->count());
      for (std::uint32_t i = 0; i < labels.size(); ++i) labels[i] = i / sampler->split().points;
      for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
        Points points;
        for (std::uint32_t i = 0; i < sampler->count(); ++i)
          points.push_back(to_double(sampler->sample(pixel, i, 0)));
        const SubsetSpacing p = subset_spacing(points, labels, parts), w = subset_spacing(points, one, 1);
        part = {part.mean + p.mean / kPixels, std::min(part.worst, p.worst)};
        whole = {whole.mean + w.mean / kPixels, std::min(whole.worst, w.worst)};
      }
      fmt::print("{:2} x 128 {:14} parts {:.3f}, worst {:.3f}; union {:.3f}, worst {:.3f}\n", parts, name,
                 part.mean, part.worst, whole.mean, whole.worst);
    }
  }
}

}  // namespace

int main(int count, char** words) {
  if (count > 1 && std::isalpha(static_cast<unsigned char>(words[1][0]))) {
    std::vector<std::string> samplers(words + 2, words + count);
    if (samplers.empty()) samplers = sampler_names();
    std::strcmp(words[1], "times") == 0 ? print_times(samplers) : print_spacing(samplers);
    return 0;
  }
  const std::size_t sets = count > 1 ? std::strtoull(words[1], nullptr, 10) : 10'000'000;
  const std::string name = count > 2 ? words[2] : "capcon-domain";
  constexpr std::size_t kChunks = 256;
  int beyond = 0;
  int compared = 0;
  // Of the large set one part: a part alone leaves out most cells of its set.
  for (const Size size : {Size{1, 1}, Size{2, 1}, Size{7, 1}, Size{16, 1}, Size{64, 1}, Size{2048, 16}}) {
    const std::uint32_t n = size.count / size.parts;
    const auto sampler = make_sampler(name, size.count, 1, size.parts);
    const std::size_t used = sets / std::max(1u, n / 16);  // as many points for large sets
    std::vector<std::vector<double>> sums(kChunks, std::vector<double>(2 * integrands().size()));
    parallel_for(kChunks, [&](std::size_t chunk) {
      std::vector<double> estimate(integrands().size());
      for (std::size_t pixel = chunk; pixel < used; pixel += kChunks) {
        std::fill(estimate.begin(), estimate.end(), 0.0);
        for (std::uint32_t i = 0; i < n; ++i) {
          const glm::dvec2 p = into_domain(
              EnsembleDomain::disk,
              to_double(sampler->sample(static_cast<std::uint32_t>(pixel), i, 0, SampleDomain::disk)));
          for (std::size_t k = 0; k < estimate.size(); ++k) estimate[k] += integrands()[k].f(p);
        }
        for (std::size_t k = 0; k < estimate.size(); ++k) {
          const double error = estimate[k] / n - integrands()[k].mean;
          sums[chunk][2 * k] += error;
          sums[chunk][2 * k + 1] += error * error;
        }
      }
    });
    for (std::size_t k = 0; k < integrands().size(); ++k) {
      double sum = 0, squares = 0;
      for (const auto& s : sums) sum += s[2 * k], squares += s[2 * k + 1];
      const double rmse = std::sqrt(squares / static_cast<double>(used)),
                   bias = sum / static_cast<double>(used);
      const double bound = 3 / std::sqrt(static_cast<double>(used));
      ++compared;
      beyond += std::abs(bias) > bound * rmse ? 1 : 0;
      fmt::print("n {:3}  {:20} sets {:9}  rmse {:.3e}  bias / rmse {:+.1e}  (3 standard errors {:.1e})\n", n,
                 integrands()[k].name, used, rmse, bias / rmse, bound);
    }
  }
  fmt::print("{} of {} beyond 3 standard errors\n", beyond, compared);
  return beyond > 1 ? 1 : 0;
}
