#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "points/measure.h"
#include "tiling/tile_quality.h"
#include "tiling/tile_spectrum.h"
#include "tiling/tiling.h"

namespace capcon {
namespace {

// Untiled capacity-constrained points (n = 1024, capacity 1024).
constexpr double kUntiledEnergy = 1.0377, kUntiledDeltaMean = 0.869;

constexpr const char* kShipped[] = {"c2n16", "c2n64", "c3n16-compact"};

TEST(ShippedTileSet, TilingsAreAsGoodAsUntiledPoints) {
  for (const char* name : kShipped) {
    const TileSet set = shipped_tile_set(name);
    for (const auto& [a, b] : {std::pair{1, 0}, {1, 1}, {2, 0}, {2, 2}, {4, 0}, {8, 0}}) {
      const TilingFigures f = tiling_figures(set, a, b, set.points_per_tile, 6, 99);
      EXPECT_LT(f.energy, 1.03 * kUntiledEnergy) << name << " " << a << "," << b;
      EXPECT_GT(f.delta_mean, 0.97 * kUntiledDeltaMean) << name << " " << a << "," << b;
    }
  }
}

// Farther apart than 0.61, what Owen-scrambled Sobol' points keep. Half of a hexagonal lattice can keep 0.71.
TEST(ShippedTileSet, EveryPrefixIsWellSpread) {
  for (const char* name : kShipped) {
    const TileSet set = shipped_tile_set(name);
    for (std::uint32_t r = 1; r <= set.points_per_tile; ++r)
      EXPECT_GE(tiling_figures(set, 8, 0, r, 2, 99).delta_mean, 0.70) << name << " " << r;
    for (const std::uint32_t r : {1u, 2u, 4u, 8u})
      EXPECT_LT(tiling_figures(set, 1, 0, r, 6, 99).energy, 1.2) << name << " " << r;
  }
}

TEST(ShippedTileSet, SpectraHaveNoSpikes) {
  for (const char* name : kShipped)
    EXPECT_LT(highest_spike(tiling_spectrum(shipped_tile_set(name), 8, 10, 99), 8).ratio(), 3) << name;
}

// No spike at the tile frequency: |sum over the points of the mean tile|^2 would repeat in every tile.
TEST(ShippedTileSet, HasNoPeriodOfATile) {
  const TileSet set = shipped_tile_set();
  for (int n = 0; n <= 8; ++n)
    for (int m = -8; m <= 8; ++m) {
      if ((m == 0 && n == 0) || m * m + n * n > 64) continue;
      std::complex<double> sum = 0;
      for (const auto& tile : set.tiles)
        for (const auto& p : tile) {
          const glm::dvec2 x = to_double(p.position);
          sum += std::polar(1.0 / 16, -2 * std::acos(-1.0) * (m * x.x + n * x.y));
        }
      EXPECT_LT(std::norm(sum), 0.2) << m << " " << n;
    }
}

}  // namespace
}  // namespace capcon
