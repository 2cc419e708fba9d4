#include "tiling/tile_spectrum.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tiling/tile_quality.h"

namespace capcon {

Spectrum tiling_spectrum(const TileSet& set, std::uint32_t side, std::uint32_t count, std::uint64_t seed) {
  std::vector<Points> tilings;
  for (std::uint32_t i = 0; i < count; ++i)
    tilings.push_back(fresh_tiling(set, GaussianTiling(side, 0), set.points_per_tile, i, seed));
  const double lattice = side * std::sqrt(double(set.points_per_tile));
  return power_spectrum(tilings, int(std::lround(2 * lattice)));
}

Spike highest_spike(const Spectrum& spectrum, std::uint32_t side) {
  assert(side >= 3);
  const int step = int(side), half = (step - 1) / 2, reach = spectrum.reach / step * step;
  Spike highest;
  for (int ky = 0; ky <= reach; ky += step)  // P(-k) = P(k)
    for (int kx = ky == 0 ? step : -reach; kx <= reach; kx += step) {
      if (kx * kx + ky * ky > spectrum.reach * spectrum.reach) continue;  // the corners of the square
      Spike spike{kx, ky, spectrum.at(kx, ky), 0};
      int count = 0;
      for (int dy = -half; dy <= half; ++dy)
        for (int dx = -half; dx <= half; ++dx) {
          const int x = kx + dx, y = ky + dy;
          const bool inside = std::max(std::abs(x), std::abs(y)) <= spectrum.reach;
          if ((dx == 0 && dy == 0) || !inside) continue;
          spike.around += spectrum.at(x, y);
          ++count;
        }
      spike.around /= count;
      if (highest.around == 0 || spike.ratio() > highest.ratio()) highest = spike;
    }
  return highest;
}

}  // namespace capcon
