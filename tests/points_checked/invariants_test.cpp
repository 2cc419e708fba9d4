#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "points/ccvt_checks.h"
#include "points/ccvt_start.h"
#include "points/checks.h"
#include "points_checked/random_input.h"

namespace capcon {
namespace {

// The short form of `points_bench invariants`, which runs a million.
TEST(Invariants, HoldAtEveryStepOnRandomInputs) {
  ::setenv("CAPCON_THREADS", "1", 0);  // inputs are too small to share out
  for (std::uint64_t number = 0; number < 1000; ++number) {
    const RandomInput input(number);
    try {
      run_input(input);
    } catch (const std::exception& error) {
      ADD_FAILURE() << input.words() << ": " << error.what();
    }
  }
  for (int kind = 0; kind < kCheckedKinds; ++kind)
    EXPECT_GT(check_tally(static_cast<Checked>(kind)).steps, 50u) << "no checks in " << kind;
}

/// Two sites' cells with K points each.
CcvtCells two_cells() {
  return random_cells(40, 16, 3).cells;
}

TEST(Invariants, ExchangesThatBreakThemAreSeen) {
  const auto trade = [](CcvtCells& cells, std::uint32_t a, std::uint32_t b) {
    std::swap(cells.x(0)[a], cells.x(1)[b]);
    std::swap(cells.y(0)[a], cells.y(1)[b]);
  };
  const auto anew = [](const CcvtCells& cells) {  // with all sums right
    std::vector<TorusPoint> points;
    for (std::size_t k = 0; k < cells.size() * cells.capacity(); ++k)
      points.push_back({cells.x(0)[k], cells.y(0)[k]});
    return CcvtCells(cells.capacity(), points);
  };
  int fell = 0, rose = 0;
  for (std::uint32_t k = 0; k < 256; ++k) {
    CcvtCells cells = two_cells();
    const ExchangeCheck check(cells, 0, 1);
    trade(cells, k / 16, k % 16);
    EXPECT_THROW(check.end(1), BrokenInvariant) << "sums of other points";
    cells = anew(cells);
    try {
      check.end(1);
      ++fell;
    } catch (const BrokenInvariant&) {
      ++rose;
    }
  }
  EXPECT_GT(fell, 5);
  EXPECT_GT(rose, 5);
  CcvtCells cells = two_cells();
  const ExchangeCheck check(cells, 0, 1);
  cells.x(0)[3] = cells.x(1)[5];
  cells.y(0)[3] = cells.y(1)[5];
  cells = anew(cells);
  EXPECT_THAT([&] { check.end(1); },
              testing::ThrowsMessage<BrokenInvariant>(testing::HasSubstr("lost or doubled")));
}

TEST(Invariants, StepsThatRaiseTheEnergyAreSeen) {
  EXPECT_NO_THROW(check_step(Checked::kLloyd, -1e-9, 0, 1));
  EXPECT_NO_THROW(check_step(Checked::kLloyd, 1e-13, 1e-12, 1));
  EXPECT_THROW(check_step(Checked::kLloyd, 0, 0, 1), BrokenInvariant) << "a tie";
  EXPECT_THROW(check_step(Checked::kLloyd, 2e-12, 1e-12, 1), BrokenInvariant);
  EXPECT_THROW(check_step(Checked::kLloyd, std::nan(""), 1e-12, 1), BrokenInvariant);
  EXPECT_THROW(check_step(Checked::kLloyd, -1, 0, std::nan("")), BrokenInvariant);
}

}  // namespace
}  // namespace capcon
