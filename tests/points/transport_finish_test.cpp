#include "points/transport_finish.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "points/ccvt.h"
#include "points/generators.h"
#include "points/measure.h"
#include "points/region_ccvt.h"
#include "points/transport.h"

namespace capcon {
namespace {

/// $CAPCON_THREADS for as long as this lives.
class Threads {
 public:
  explicit Threads(const char* count) { ::setenv("CAPCON_THREADS", count, 1); }
  ~Threads() { ::unsetenv("CAPCON_THREADS"); }
};

TEST(TransportFinish, ReachesTheEnergyAndEqualAreas) {
  CcvtOptions options;
  options.finish = true;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    options.seed = seed;
    const CcvtResult result = ccvt(options);
    EXPECT_LT(result.energy, 1.010) << seed;
    EXPECT_GT(result.energy, 1.0);
    EXPECT_FALSE(result.stopped);
    EXPECT_EQ(result.capacity, 64u);
    EXPECT_NEAR(transport_energy(result.points), result.energy, 1e-9);
    const Measures measures = measure(result.points);
    EXPECT_LE(measures.energy, result.energy);  // ordinary cells carry every place to the nearest point
    EXPECT_LT(measures.area_sd, 0.035);
  }
}

TEST(TransportFinish, EnergyFallsAndAreasEndEqual) {
  for (const char* method : {"random", "jittered", "sobol-owen", "ccvt"}) {
    const Points start = generate(method, {500, 3, 16});
    double last = 1.05 * transport_energy(start);
    FinishOptions options;
    options.stop = [&](int round, double energy) {
      // The dual value that the descent goes by is the energy but for the square of the areas' errors.
      EXPECT_LE(energy, last) << method << " " << round;
      last = energy;
      return false;
    };
    const FinishResult result = transport_finish(start, options);
    EXPECT_LT(result.area_error, 1e-10);
    EXPECT_LT(result.energy, 1.013) << method;
    EXPECT_NEAR(result.energy, transport_energy(result.points), 1e-9);
    // At the minimum, sites stand at the centroids of their power cells.
    Transport cells(result.points, std::vector<double>(500, 1 / 500.0));
    cells.balance(1e-10);
    double offset2 = 0;
    for (std::size_t i = 0; i < 500; ++i) {
      EXPECT_NEAR(500 * cells.diagram().moments(i).area, 1, 1e-9);
      const glm::dvec2 first = cells.diagram().moments(i).first;
      offset2 += 500 * 500 * (first.x * first.x + first.y * first.y);
    }
    EXPECT_LT(std::sqrt(offset2), 0.03) << "in units of the spacing, root mean square";
  }
}

TEST(TransportFinish, AnyCountAndDegenerateInput) {
  for (const std::uint32_t n : {1u, 2u, 3u, 4u, 5u, 7u, 12u}) {
    const FinishResult result = transport_finish(generate("random", {n, 2}));
    ASSERT_EQ(result.points.size(), n);
    EXPECT_LT(result.area_error, 1e-10) << n;
    EXPECT_LE(result.energy, 1.0 / 6 / kHexagonEnergy + 0.4) << n;
    EXPECT_GE(result.energy, 0.9999) << n;
    for (const glm::dvec2& p : result.points) EXPECT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
  }
  EXPECT_TRUE(transport_finish({}).points.empty());
  EXPECT_NEAR(transport_finish({{0.5, 0.25}}).energy, 1.0 / 6 / kHexagonEnergy, 1e-12);
  EXPECT_LT(transport_finish(Points(30, {0.5, 0.5})).energy, 1.1) << "all in one place";
  Points grid;
  for (int i = 0; i < 64; ++i) grid.emplace_back(i % 8 / 8.0, i / 8 / 8.0);  // a saddle: it may stay, or fall
  EXPECT_LE(transport_finish(grid).energy, 1.0 / 6 / kHexagonEnergy + 1e-9);
}

TEST(TransportFinish, SameBitsForAnyNumberOfThreads) {
  CcvtOptions options;
  options.sites = 6000;  // batches and blocks are large enough for several threads
  options.capacity = 16;
  options.finish = true;
  int rounds = 0;
  options.stop = [&] { return rounds++ > 60; };
  Points first;
  double energy = 0;
  for (const char* threads : {"1", "2", "4"}) {
    const Threads scope(threads);
    rounds = 0;
    const CcvtResult result = ccvt(options);
    if (first.empty()) first = result.points, energy = result.energy;
    EXPECT_EQ(result.points, first) << threads;
    EXPECT_EQ(result.energy, energy) << threads;
    EXPECT_EQ(transport_energy(result.points), transport_energy(first)) << threads;
  }
}

TEST(Ccvt, SameBitsForAnyNumberOfThreads) {
  CcvtResult first;
  for (const char* threads : {"1", "2", "4"}) {
    const Threads scope(threads);
    CcvtOptions options;
    options.sites = 6000;
    options.capacity = 128;  // with the account of arrivals
    int passes = 0;
    options.stop = [&] { return passes++ > 25; };
    const CcvtResult result = ccvt(options);
    if (first.points.empty()) first = result;
    EXPECT_EQ(result.points, first.points) << threads;
    EXPECT_EQ(result.swaps, first.swaps) << threads;
  }
}

TEST(Ccvt, StopsWithAValidSet) {
  for (const int most : {0, 3, 20, 50}) {
    CcvtOptions options;
    options.sites = 300;
    options.capacity = 256;
    options.finish = most > 30;  // so late it is under way
    int asked = 0;
    options.stop = [&] { return asked++ >= most; };
    const CcvtResult result = ccvt(options);
    EXPECT_TRUE(result.stopped);
    EXPECT_EQ(result.points.size(), 300u);
    EXPECT_TRUE(result.capacity == 16 || result.capacity == 64 || result.capacity == 256) << result.capacity;
    EXPECT_GT(measure(result.points).delta_mean, 0.6);
  }
}

/// In the square: cells of equal area, cut off at the sides, by counting; better than swaps; two points at
/// the places that are known; and never outside.
TEST(TransportFinish, KnowsTheSquare) {
  FinishOptions square;
  square.square = true;
  const FinishResult two = transport_finish({{0.3, 0.2}, {0.6, 0.9}}, square);
  const glm::dvec2 d = two.points[1] - two.points[0];  // halves: the centroids are half a side apart
  EXPECT_NEAR(std::max(std::abs(d.x), std::abs(d.y)), 0.5, 1e-3);
  EXPECT_NEAR(std::min(std::abs(d.x), std::abs(d.y)), 0, 1e-3);
  EXPECT_NEAR(two.energy, 2 * (1 / 12. + 1 / 48.) / kHexagonEnergy, 1e-4);

  CcvtOptions options;
  options.sites = 200;
  options.capacity = 64;
  const Points start = region_ccvt({Domain::kSquare, {}}, options);
  const FinishResult result = transport_finish(start, square);
  EXPECT_LT(result.area_error, 1e-9);
  // The energy of 2^16 places, each to the nearest point, is less than that of the cells, but not by much.
  const auto energy_of = [](const Points& points) {
    double sum = 0;
    for (int k = 0; k < 1 << 16; ++k) {
      const glm::dvec2 p((k % 256 + 0.5) / 256, (k / 256 + 0.5) / 256);
      double best = 9;
      for (const glm::dvec2& q : points) best = std::min(best, glm::dot(q - p, q - p));
      sum += best;
    }
    return static_cast<double>(points.size()) * sum / (1 << 16) / kHexagonEnergy;
  };
  const double energy = energy_of(result.points);
  EXPECT_LE(energy, result.energy + 1e-3);
  EXPECT_GT(energy, result.energy - 0.01);
  EXPECT_LT(energy, energy_of(start) - 0.02);
  for (const glm::dvec2& p : result.points) EXPECT_TRUE(p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1);
  options.finish = true;
  EXPECT_EQ(region_ccvt({Domain::kSquare, {}}, options), result.points);
  EXPECT_THROW(region_ccvt({Domain::kDisk, {}}, options), InputError);
}

/// Each set has grains of hexagons, yet over sets the power of the first ring does not depend on the
/// direction.
TEST(TransportFinish, HasNoDirectionOfItsOwn) {
  constexpr int kSets = 64, kDirections = 6;
  std::vector<double> power(kDirections, 0);
  for (std::uint64_t seed = 1; seed <= kSets; ++seed) {
    CcvtOptions options;
    options.sites = 256;
    options.capacity = 64;
    options.finish = true;
    options.seed = seed;
    const Points points = ccvt(options).points;
    for (int u = -26; u <= 26; ++u) {
      for (int v = 0; v <= 26; ++v) {
        const double length = std::hypot(u, v), angle = std::atan2(v, u);
        if (length < 12 || length > 22 || (v == 0 && u < 0)) continue;
        double re = 0, im = 0;
        for (const glm::dvec2& p : points) {
          re += std::cos(2 * M_PI * (u * p.x + v * p.y));
          im += std::sin(2 * M_PI * (u * p.x + v * p.y));
        }
        power[std::min(kDirections - 1, static_cast<int>(angle / M_PI * kDirections))] +=
            (re * re + im * im) / 256;
      }
    }
  }
  const auto [least, most] = std::minmax_element(power.begin(), power.end());
  EXPECT_LT(*most / *least, 1.6);
}

}  // namespace
}  // namespace capcon
