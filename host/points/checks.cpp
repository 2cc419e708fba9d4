#include "points/checks.h"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cmath>
#include <limits>

namespace capcon {
namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();

struct Tally {
  std::atomic<std::uint64_t> steps{0};
  std::atomic<double> highest{kNone}, part{kNone};
};
std::array<Tally, kCheckedKinds> tallies;
const char* const kNames[kCheckedKinds] = {
    "ccvt", "cell swaps", "near swaps", "partition", "transport finish", "fpo", "lloyd"};

void raise(std::atomic<double>& most, double value) {
  for (double old = most; value > old && !most.compare_exchange_weak(old, value);) {
  }
}

}  // namespace

CheckTally check_tally(Checked kind) {
  const Tally& tally = tallies[static_cast<std::size_t>(kind)];
  const auto seen = [](double value) { return value == kNone ? 0 : value; };
  return {tally.steps, seen(tally.highest), seen(tally.part)};
}

void require(bool holds, const std::string& what) {
  if (!holds) throw BrokenInvariant(what);
}

void check_step(Checked kind, double rise, double bound, double scale) {
  const auto k = static_cast<std::size_t>(kind);
  const bool fine = std::isfinite(scale) && (bound > 0 ? rise <= bound : rise < 0);
  if (!fine)
    throw BrokenInvariant(fmt::format("{}: a step raised an energy of {} by {}, and rounding explains {}",
                                      kNames[k], scale, rise, bound));
  ++tallies[k].steps;
  if (scale > 0) raise(tallies[k].highest, rise / scale);
  if (bound > 0) raise(tallies[k].part, rise / bound);
}

}  // namespace capcon
