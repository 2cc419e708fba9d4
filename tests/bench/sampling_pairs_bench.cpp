// What a sample's dimension pairs err together: integrands of a place in the pixel (pair 1, the square) and a
// point of a light (pair 3, the disk), MSE beside padded Owen-scrambled nets, with 95 % intervals:
//   sampling_pairs_bench [trials] [samplers...]
// "joint" are Owen-scrambled Sobol' points in all four dimensions at once (Burley 2020; direction numbers of
// Joe and Kuo 2008), which no pair shuffles.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "base/hash.h"
#include "base/parallel.h"
#include "points/ensemble.h"
#include "sampling/bits.h"
#include "sampling/sampler.h"

namespace {

using namespace capcon;

constexpr std::size_t kChunks = 64;

struct Sample {
  glm::dvec2 pixel, light;  ///< in the unit square, in the unit disk
};

using Samples = std::function<std::vector<Sample>(std::uint32_t trial)>;

struct Family {
  const char* name;
  /// Of four uniform numbers for a trial.
  double (*value)(const Sample& s, const double* u);
};

double along(glm::dvec2 p, double turn) {
  const double angle = 2 * std::numbers::pi * turn;
  return p.x * std::cos(angle) + p.y * std::sin(angle);
}

// Shadows of straight edges: of the light alone, moving with the pixel's place, beside an edge of the pixel;
// and a smooth one.
const Family kFamilies[] = {
    {"light",
     [](const Sample& s, const double* u) { return along(s.light, u[0]) > 2 * u[1] - 1 ? 1.0 : 0.0; }},
    {"moving",
     [](const Sample& s, const double* u) {
       return along(s.light, u[0]) + along(s.pixel - 0.5, u[2]) > 2 * u[1] - 1 ? 1.0 : 0.0;
     }},
    {"product",
     [](const Sample& s, const double* u) {
       return along(s.light, u[0]) > u[1] - 0.5 && along(s.pixel - 0.5, u[2]) > 0.5 * (u[3] - 0.5) ? 1.0
                                                                                                   : 0.0;
     }},
    {"smooth", [](const Sample& s, const double* u) {
       return std::exp(along(s.light, u[0]) + 2 * along(s.pixel - 0.5, u[2]) +
                       4 * (s.light.x - u[1] + 0.5) * (s.pixel.y - 0.5));
     }}};

Samples of_sampler(const std::string& name, std::uint32_t n) {
  const std::shared_ptr<const Sampler> image = make_sampler(name, n, 1), lights = make_sampler(name, n, 2);
  return [=](std::uint32_t trial) {
    std::vector<Sample> all(n);
    for (std::uint32_t i = 0; i < n; ++i) {
      all[i] = {
          to_double(image->sample(trial, i, 1, SampleDomain::square)),
          into_domain(EnsembleDomain::disk, to_double(lights->sample(trial, i, 3, SampleDomain::disk)))};
    }
    return all;
  };
}

/// Bit k of an index contributes directions[k], by Sobol's recurrence.
std::vector<std::uint32_t> directions(std::uint32_t degree, std::uint32_t polynomial,
                                      std::vector<std::uint32_t> m) {
  for (std::uint32_t k = degree; k < 32; ++k) {
    std::uint32_t next = m[k - degree] ^ (m[k - degree] << degree);
    for (std::uint32_t j = 1; j < degree; ++j)
      if ((polynomial >> (degree - 1 - j) & 1) != 0) next ^= m[k - j] << j;
    m.push_back(next);
  }
  for (std::uint32_t k = 0; k < 32; ++k) m[k] <<= 31 - k;
  return m;
}

Samples joint(std::uint32_t n) {
  const std::vector<std::vector<std::uint32_t>> of = {directions(1, 0, {1}), directions(2, 1, {1, 3}),
                                                      directions(3, 1, {1, 3, 1})};
  return [=](std::uint32_t trial) {
    std::vector<Sample> all;
    for (std::uint32_t i = 0; i < n; ++i) {
      double u[4];
      for (std::uint32_t d = 0; d < 4; ++d) {
        std::uint32_t x = 0;
        if (d == 0) x = reverse_bits(i);
        for (std::uint32_t k = 0; d > 0 && k < 32; ++k) x ^= (i >> k & 1) != 0 ? of[d - 1][k] : 0;
        const auto key = static_cast<std::uint32_t>(mix64(9, d, trial));
        u[d] = reverse_bits(owen_scramble_reversed(reverse_bits(x), key)) * 0x1p-32;
      }
      all.push_back({{u[0], u[1]}, into_domain(EnsembleDomain::disk, {u[2], u[3]})});
    }
    return all;
  };
}

/// Sums of squared errors over chunks of trials. The truth of a trial: many sets of capcon-domain.
std::vector<double> errors(const Family& f, const Samples& samples, std::size_t trials,
                           const std::vector<double>& truths) {
  std::vector<double> sums(kChunks);
  parallel_for(kChunks, [&](std::size_t chunk) {
    for (std::size_t t = chunk; t < trials; t += kChunks) {
      const double u[4] = {uniform64(7, t, 0), uniform64(7, t, 1), uniform64(7, t, 2), uniform64(7, t, 3)};
      double sum = 0;
      const auto all = samples(static_cast<std::uint32_t>(t));
      for (const Sample& s : all) sum += f.value(s, u);
      const double error = sum / static_cast<double>(all.size()) - truths[t];
      sums[chunk] += error * error;
    }
  });
  return sums;
}

std::vector<double> truths_of(const Family& f, std::size_t trials) {
  std::vector<double> truths(trials);
  const Samples samples = joint(1u << 14);
  parallel_for(trials, [&](std::size_t t) {
    const double u[4] = {uniform64(7, t, 0), uniform64(7, t, 1), uniform64(7, t, 2), uniform64(7, t, 3)};
    for (const Sample& s : samples(static_cast<std::uint32_t>(t + 0x80000000u)))
      truths[t] += f.value(s, u) * 0x1p-14;
  });
  return truths;
}

}  // namespace

int main(int count, char** words) {
  const std::size_t trials = count > 1 ? std::strtoull(words[1], nullptr, 10) : 4000;
  std::vector<std::string> samplers(words + std::min(count, 2), words + count);
  if (samplers.empty()) samplers = {"joint", "pmj02", "capcon-domain"};
  std::vector<std::vector<double>> truths;
  for (const Family& f : kFamilies) truths.push_back(truths_of(f, trials));
  for (const std::uint32_t n : {16u, 24u, 64u, 256u}) {
    std::vector<std::vector<double>> base;
    for (std::size_t k = 0; k < std::size(kFamilies); ++k)
      base.push_back(errors(kFamilies[k], of_sampler("sobol-owen", n), trials, truths[k]));
    for (const std::string& name : samplers) {
      const Samples samples = name == "joint" ? joint(n) : of_sampler(name, n);
      fmt::print("n {:4} {:14}", n, name);
      for (std::size_t k = 0; k < std::size(kFamilies); ++k) {
        const auto above = errors(kFamilies[k], samples, trials, truths[k]);
        const double a = std::accumulate(above.begin(), above.end(), 0.0),
                     b = std::accumulate(base[k].begin(), base[k].end(), 0.0);
        double squares = 0;
        for (std::size_t c = 0; c < kChunks; ++c) {
          const double without = (a - above[c]) / (b - base[k][c]) - a / b;
          squares += without * without;
        }
        fmt::print("  {} {:.3f} +- {:.3f}", kFamilies[k].name, a / b,
                   1.998 * std::sqrt(squares * (kChunks - 1) / kChunks));
      }
      fmt::print("\n");
    }
  }
}
