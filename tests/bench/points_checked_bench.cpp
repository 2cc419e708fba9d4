// Random small inputs through the point optimisers with every invariant checked at every step
// (points/checks.h):
//
//   points_bench invariants [COUNT]         inputs 0 to COUNT - 1, a million unless said
//   points_bench invariants --only NUMBER   one of them, to see it again
//
// Prints how many steps were checked and how the energies went, and exits with 1 when a promise is broken.

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <string>

#include "points/checks.h"
#include "points_checked/random_input.h"

namespace {

using namespace capcon;

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Slowest {
  double seconds = 0;
  std::uint64_t number = 0;
};

/// Whether all promises were kept.
bool run(std::uint64_t number, Slowest& slowest) {
  const RandomInput input(number);
  const double before = seconds();
  try {
    run_input(input);
  } catch (const std::exception& error) {
    fmt::print("{}\n  {}\n  again: points_bench invariants --only {}\n", input.words(), error.what(), number);
    return false;
  }
  const double taken = seconds() - before;
  if (taken > slowest.seconds) slowest = {taken, number};
  return true;
}

void print_tallies() {
  const char* const names[kCheckedKinds] = {"ccvt, regions",    "cell swaps", "near swaps", "partition",
                                            "transport finish", "fpo",        "lloyd"};
  for (int k = 0; k < kCheckedKinds; ++k) {
    const CheckTally tally = check_tally(static_cast<Checked>(k));
    fmt::print("{:<18} {:>12} steps  energy changes by {:.3g} of it or less", names[k], tally.steps,
               tally.highest);
    fmt::print("  {}\n", tally.part > 0 ? fmt::format("at most {:.3g} of what rounding allows", tally.part)
                                        : "it rose at none");
  }
}

}  // namespace

int main(int count, char** words) {
  ::setenv("CAPCON_THREADS", "1", 0);  // inputs are too small to share out
  std::uint64_t inputs = 1'000'000, first = 0;
  if (count == 3 && std::string(words[1]) == "--only") {
    first = std::strtoull(words[2], nullptr, 10);
    inputs = 1;
    fmt::print("{}\n", RandomInput(first).words());
  } else if (count == 2) {
    inputs = std::strtoull(words[1], nullptr, 10);
  }
  const double begin = seconds();
  std::uint64_t broken = 0;
  Slowest slowest;
  for (std::uint64_t k = first; k < first + inputs; ++k) broken += run(k, slowest) ? 0 : 1;
  fmt::print("{} inputs in {:.1f} s, {} broke a promise; the slowest, {}, took {:.3f} s\n", inputs,
             seconds() - begin, broken, slowest.number, slowest.seconds);
  print_tallies();
  return broken > 0 ? 1 : 0;
}
