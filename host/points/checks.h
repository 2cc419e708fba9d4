#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace capcon {

/// Whether this translation unit checks the optimisers' invariants at every step: as with assert, in builds
/// without NDEBUG (the debug preset), and with CAPCON_CHECKS, which a second copy of the optimisers for
/// tests/points_checked has. Checks stand under `if constexpr (kChecks)`: they always compile, and cost a
/// release nothing.
#if defined(CAPCON_CHECKS) || !defined(NDEBUG)
constexpr bool kChecks = true;
#else
constexpr bool kChecks = false;
#endif

/// An optimiser did what it never may: our own mistake, never the user's.
class BrokenInvariant : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Whose steps are counted.
enum class Checked : std::uint8_t { kCcvt, kCells, kNear, kPartition, kTransport, kFpo, kLloyd };
constexpr int kCheckedKinds = 7;

/// What the checks of one kind have seen so far in this process: for benches, hence the one global in here.
struct CheckTally {
  std::uint64_t steps = 0;
  double highest =
      0;            ///< largest rise of the energy as part of it or, below 0, the smallest fall; 0: no step
  double part = 0;  ///< largest rise as part of what rounding may make of it, where it may
};
CheckTally check_tally(Checked kind);

/// Throws BrokenInvariant unless it holds.
void require(bool holds, const std::string& what);

/// After a step that changed an energy of size `scale` by `rise`: throws BrokenInvariant unless that is at
/// most `bound`, the rounding; with a bound of 0, unless the energy fell.
void check_step(Checked kind, double rise, double bound, double scale);

}  // namespace capcon
