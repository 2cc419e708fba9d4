#include "points/screen_mask.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>

#include "base/error.h"
#include "base/hash.h"

namespace capcon {
namespace {

constexpr int kColumns = ScreenMask::kColumns;

const Ensemble& sets_of_four() {
  static const Ensemble e = make_ensemble({.points = 4, .sets = 16, .effort = 1e7});
  return e;
}

// So that a shifted mask gives every set and symmetry with the same probability.
TEST(ScreenMask, HasEveryKeyEquallyOften) {
  for (const std::uint32_t sets : {1u, 3u, 12u, 16u, 31u, 64u, 255u, 256u}) {
    EXPECT_EQ(mask_rows(sets) * kColumns % (8 * sets), 0u) << sets;
    EXPECT_GE(mask_rows(sets), 64u);
    EXPECT_LT(mask_rows(sets), 256u);
  }
  const ScreenMask mask = make_screen_mask(sets_of_four(), EnsembleDomain::disk);
  std::map<int, std::size_t> times;
  for (const auto key : mask.keys) ++times[key];
  EXPECT_EQ(times.size(), 8u * sets_of_four().sets);
  for (const auto& [key, count] : times) EXPECT_EQ(count, mask.keys.size() / times.size()) << key;
}

/// What each pixel errs at a half-plane of the disk, the same for all pixels.
std::vector<double> errors(const ScreenMask& mask, double angle, double distance) {
  const Ensemble& e = sets_of_four();
  const double share =
      (std::acos(distance) - distance * std::sqrt(1 - distance * distance)) / std::numbers::pi;
  std::vector<double> result;
  for (const auto key : mask.keys) {
    double inside = 0;
    for (int i = 0; i < 4; ++i) {
      const std::uint32_t c = e.cells[std::size_t(key >> 3) * 4 + i];
      const glm::dvec2 u((c % e.columns + 0.5) / e.columns, (c / e.columns + 0.5) / e.rows);
      const glm::dvec2 p =
          into_domain(EnsembleDomain::disk, apply_symmetry(EnsembleDomain::disk, key & 7, u));
      inside += p.x * std::cos(angle) + p.y * std::sin(angle) > distance ? 0.25 : 0;
    }
    result.push_back(inside - share);
  }
  return result;
}

/// Mean square behind a Gaussian of sigma 1 pixel, on the torus.
double softened(const std::vector<double>& errors, int rows) {
  double sum = 0;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < kColumns; ++x) {
      double mean = 0, weights = 0;
      for (int v = -3; v <= 3; ++v) {
        for (int u = -3; u <= 3; ++u) {
          const double weight = std::exp(-(u * u + v * v) / 2.0);
          mean +=
              weight * errors[std::size_t((y + v + rows) % rows) * kColumns + (x + u + kColumns) % kColumns];
          weights += weight;
        }
      }
      sum += mean * mean / (weights * weights);
    }
  }
  return sum;
}

TEST(ScreenMask, NeighboursErrorsCancel) {
  const ScreenMask mask = make_screen_mask(sets_of_four(), EnsembleDomain::disk);
  ScreenMask shuffled = mask;
  for (std::size_t k = shuffled.keys.size(); k > 1; --k)
    std::swap(shuffled.keys[k - 1], shuffled.keys[mix64(5, 6, k) % k]);
  double blue = 0, white = 0;
  for (int k = 0; k < 40; ++k) {
    const double angle = 2 * std::numbers::pi * uniform64(1, k, 0), distance = 2 * uniform64(1, k, 1) - 1;
    blue += softened(errors(mask, angle, distance), int(mask.rows));
    white += softened(errors(shuffled, angle, distance), int(mask.rows));
  }
  EXPECT_LT(blue, 0.75 * white);
}

TEST(ScreenMask, SymmetriesKeepTheDomainAndAreEight) {
  for (const auto domain : {EnsembleDomain::square, EnsembleDomain::disk, EnsembleDomain::cylinder}) {
    std::map<std::pair<int, int>, int> images;
    for (std::uint32_t g = 0; g < 8; ++g) {
      const glm::dvec2 p = apply_symmetry(domain, g, {0.13, 0.37});
      ++images[{int(std::lround(p.x * 100)), int(std::lround(p.y * 100))}];
      EXPECT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y <= 1);
    }
    EXPECT_EQ(images.size(), 8u);
  }
}

TEST(ScreenMask, RefusesLargeSets) {
  Ensemble e{32, 16, 1, {}};
  for (std::uint32_t k = 0; k < 512; ++k) e.cells.push_back(k);
  EXPECT_THROW(make_screen_mask(e, EnsembleDomain::square), InputError);
}

}  // namespace
}  // namespace capcon
