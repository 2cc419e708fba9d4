#pragma once

#include <cstdint>
#include <string>

#include "points/point_set.h"
#include "points/region.h"

namespace capcon {

/// Small inputs that are hard on optimisers, addressed by number: 1 to 64 points, primes among them,
/// capacities from 1 to 64, starts in one place, on lines, on borders and grids, densities of any contrast.
struct RandomInput {
  explicit RandomInput(std::uint64_t number);

  enum class Task {
    kCells,
    kCcvt,
    kRegion,
    kCellSwaps,
    kNearSwaps,
    kPartition,
    kTransport,
    kFpo,
    kLloyd,
    kMeasure
  };
  enum class Start {
    kRandom,
    kOnePlace,
    kRow,
    kColumn,
    kDiagonal,
    kSeam,
    kGrid,
    kLattice,
    kTwins,
    kTight,
    kTouching,
    kOneApart
  };
  enum class Mass { kNone, kContrast, kOneTexel, kHalf, kLine, kBoard, kTiny, kHuge, kWide, kTall, kOne };

  std::uint64_t number;
  Task task;
  Start start;
  Mass mass;
  Domain domain;
  std::uint32_t n, capacity;

  /// `count` points in the pattern of `start`, all in [0, 1)^2.
  Points places(std::uint32_t count) const;
  Region region() const;
  std::string words() const;
  double u(std::uint64_t k) const;  ///< random number k of this input
};

/// Runs it. Throws BrokenInvariant, or what else should not happen, when a promise is broken.
void run_input(const RandomInput& input);

}  // namespace capcon
