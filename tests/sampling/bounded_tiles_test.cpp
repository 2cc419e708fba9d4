// The sampler capcon-bounded: tilings of the square with a border.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/error.h"
#include "sampling/sampler.h"

namespace capcon {
namespace {

Points set_of(const Sampler& sampler, std::uint32_t pixel, std::uint32_t dimension = 0) {
  Points points;
  for (std::uint32_t i = 0; i < sampler.count(); ++i)
    points.push_back(to_double(sampler.sample(pixel, i, dimension)));
  return points;
}

TEST(BoundedTileSampler, RefusesOtherNumbersAndNamesOneThatGoes) {
  for (const std::uint32_t count : {1u, 16u, 63u, 65u, 128u, 1u << 21}) {
    try {
      make_sampler("capcon-bounded", count, 1);
      ADD_FAILURE() << count;
    } catch (const InputError& error) {
      const std::string near = count < 100 ? "take 64," : count == 128 ? "take 144," : "take 1048576,";
      EXPECT_NE(std::string(error.what()).find(near), std::string::npos) << error.what();
    }
  }
  EXPECT_EQ(make_sampler("capcon-bounded", 64, 1)->count(), 64u);
  EXPECT_EQ(make_sampler("capcon-bounded", 65536, 1)->tables().constants[0], 4096u);
}

// As many points as a tile has in each of the k x k squares, whatever the colours and the symmetry; other
// pixels, dimensions and seeds have other sets.
TEST(BoundedTileSampler, EveryTileHasItsPoints) {
  for (const std::uint32_t side : {2u, 3u, 5u, 8u}) {
    const auto sampler = make_sampler("capcon-bounded", 16 * side * side, 3);
    for (std::uint32_t pixel = 0; pixel < 20; ++pixel) {
      std::vector<int> counts(side * side);
      for (const glm::dvec2 p : set_of(*sampler, pixel, pixel % 3))
        ++counts[std::uint32_t(p.x * side) + side * std::uint32_t(p.y * side)];
      EXPECT_EQ(std::ranges::count(counts, 16), side * side);
    }
  }
  const auto a = make_sampler("capcon-bounded", 64, 1), other = make_sampler("capcon-bounded", 64, 2);
  EXPECT_EQ(set_of(*a, 5), set_of(*make_sampler("capcon-bounded", 64, 1), 5));
  EXPECT_NE(set_of(*a, 5), set_of(*a, 6));
  EXPECT_NE(set_of(*a, 5), set_of(*a, 5, 1));
  EXPECT_NE(set_of(*a, 5), set_of(*other, 5));
}

// The mean of the estimate over many pixels is the integral: within 4.5 standard errors, which is 2 % of one
// set's RMSE at 64 points.
TEST(BoundedTileSampler, IsUnbiased) {
  for (const auto& [count, pixels] : {std::pair{64u, 50000u}, {144u, 15000u}, {256u, 8000u}}) {
    const auto sampler = make_sampler("capcon-bounded", count, 11);
    double sums[3] = {}, squares[3] = {};
    for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
      double errors[3] = {-(std::numbers::e - 1) / 3, -std::numbers::pi * 0.35 * 0.35, -0.3 * 0.1};
      for (const glm::dvec2 p : set_of(*sampler, pixel)) {
        errors[0] += std::exp(p.x) * p.y * p.y / count;
        errors[1] += (std::hypot(p.x - 0.4, p.y - 0.5) < 0.35 ? 1.0 : 0.0) / count;
        errors[2] += (p.x > 0.7 && p.y < 0.1 ? 1.0 : 0.0) / count;
      }
      for (int k = 0; k < 3; ++k) sums[k] += errors[k], squares[k] += errors[k] * errors[k];
    }
    for (int k = 0; k < 3; ++k) {
      const double mean = sums[k] / pixels, rmse = std::sqrt(squares[k] / pixels);
      EXPECT_LT(std::abs(mean), 4.5 * rmse / std::sqrt(double(pixels))) << count << " integrand " << k;
    }
  }
}

// 8 x 8 cells over pixels, chi-square with 63 degrees of freedom; 121 is its 0.99999 quantile. Where points
// come in an order of their own, each is uniform by itself.
TEST(BoundedTileSampler, EveryPointIsUniformWhereTheOrderIsRandom) {
  const auto sampler = make_sampler("capcon-bounded", 64, 5);
  for (const std::uint32_t index : {0u, 63u}) {
    std::array<int, 64> cells{};
    constexpr int kPixels = 64000;
    for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
      const FixedPoint p = sampler->sample(pixel, index, 2);
      ++cells[(p.x >> 29) * 8 + (p.y >> 29)];
    }
    double chi2 = 0;
    for (const int c : cells) chi2 += (c - kPixels / 64.0) * (c - kPixels / 64.0) / (kPixels / 64.0);
    EXPECT_LT(chi2, 121) << index;
  }
}

// The theory's gain: less error than Owen-scrambled points at edges, by at least a tenth in MSE.
TEST(BoundedTileSampler, ErrsLessAtEdgesThanOwenScrambledPoints) {
  const auto mse = [](const char* name) {
    const auto sampler = make_sampler(name, 64, 7);
    double sum = 0;
    for (std::uint32_t pixel = 0; pixel < 4000; ++pixel) {
      const double angle = 0.618 * pixel;
      double error = -0.5;
      for (const glm::dvec2 p : set_of(*sampler, pixel))
        error += (std::cos(angle) * (p.x - 0.5) + std::sin(angle) * (p.y - 0.5) > 0 ? 1.0 : 0.0) / 64;
      sum += error * error;
    }
    return sum;
  };
  EXPECT_LT(mse("capcon-bounded"), 0.9 * mse("sobol-owen"));
}

// Parts by labels (2, 8 and 4 a tile), and others: the union has the set's cells, with other places in them,
// and each part alone is unbiased.
TEST(BoundedTileSampler, PartsHaveTheSetsCellsAndAreUnbiased) {
  for (const auto& [count, parts] : {std::pair{64u, 2u}, {64u, 8u}, {256u, 4u}, {64u, 32u}, {144u, 9u}}) {
    const auto cut = make_sampler("capcon-bounded", count, 3, parts);
    const auto whole = make_sampler("capcon-bounded", count, 3);
    const double reach = 0.25 / std::sqrt(count / 16.0);  // two cells, one of them a pair
    const Points union_of_parts = set_of(*cut, 9);
    for (const glm::dvec2 p : set_of(*whole, 9))
      EXPECT_TRUE(std::ranges::any_of(
          union_of_parts,
          [&](glm::dvec2 q) { return std::max(std::abs(p.x - q.x), std::abs(p.y - q.y)) < reach; }))
          << count << " in " << parts;
    std::vector<int> counts(count / 16);
    const auto side = std::uint32_t(std::lround(std::sqrt(count / 16.0)));
    for (const glm::dvec2 p : union_of_parts)
      ++counts[std::uint32_t(p.x * side) + side * std::uint32_t(p.y * side)];
    EXPECT_EQ(std::ranges::count(counts, 16), side * side) << count << " in " << parts;
    constexpr int kPixels = 10000;
    const std::uint32_t size = count / parts;
    double sum = 0, squares = 0;
    for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
      double error = -1 / 3.0;
      for (std::uint32_t i = 0; i < size; ++i) {
        const glm::dvec2 p = to_double(cut->sample(pixel, i, 0));
        error += p.x * p.x / size;
      }
      sum += error, squares += error * error;
    }
    EXPECT_LT(std::abs(sum / kPixels), 4.5 * std::sqrt(squares) / kPixels) << count << " in " << parts;
  }
}

}  // namespace
}  // namespace capcon
