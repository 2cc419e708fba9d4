#include "tiling/tile_spectrum.h"

#include <gtest/gtest.h>

#include "tiling/region_layout.h"
#include "tiling/tied_points.h"

namespace capcon {
namespace {

Spectrum flat(int reach) {
  Spectrum spectrum{1024, 10, reach, {}};
  spectrum.power.assign(std::size_t(spectrum.side()) * spectrum.side(), 0.5);
  return spectrum;
}

TEST(HighestSpike, IsPowerOverTheMeanAround) {
  Spectrum spectrum = flat(32);
  const auto set = [&](int kx, int ky, double p) {
    spectrum.power[std::size_t(ky + 32) * spectrum.side() + (kx + 32)] = p;
  };
  set(-8, 16, 2), set(8, -16, 2);
  set(0, 0, 1e6);    // not counted
  set(3, 20, 9);     // no multiple of 8, but nobody's surroundings matter more than the spike's
  set(24, 24, 100);  // beyond the reach
  const Spike spike = highest_spike(spectrum, 8);
  EXPECT_EQ(spike.kx, -8);
  EXPECT_EQ(spike.ky, 16);
  EXPECT_EQ(spike.power, 2);
  EXPECT_EQ(spike.around, 0.5);
  EXPECT_EQ(spike.ratio(), 4);
}

// One tile alone repeats: all power sits at multiples of the tile frequency, P = tiles / nt |F|^2.
TEST(HighestSpike, SeesARepeatedTile) {
  const TileSet one = to_tile_set(random_tied_points(1, 9, {0, 0, 9}, 1), "");
  const Spectrum spectrum = tiling_spectrum(one, 8, 2, 1);
  EXPECT_EQ(spectrum.reach, 48);
  EXPECT_LT(spectrum.at(3, 5), 1e-9);
  EXPECT_GT(highest_spike(spectrum, 8).ratio(), 1e6);
}

}  // namespace
}  // namespace capcon
