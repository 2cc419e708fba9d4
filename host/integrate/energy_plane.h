#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "points/measure.h"

namespace capcon::integrate {

/// The text's open question in numbers: how low a generator's energy is and how equal its areas.
struct GeneratorEnergy {
  std::string method;
  std::uint32_t sets = 0;
  double energy = 0;   ///< mean of Measures::energy, 1 = hexagons
  double area_sd = 0;  ///< mean of Measures::area_sd, 0 = equal areas
};

/// Every generator and the tiles, at n points, over base_sets(n) sets each.
std::vector<GeneratorEnergy> energy_plane(std::uint32_t n, std::uint64_t seed);

inline constexpr std::uint32_t kPlanePoints = 1024;

}  // namespace capcon::integrate
