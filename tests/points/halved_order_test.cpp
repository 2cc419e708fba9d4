#include "points/halved_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace capcon {
namespace {

constexpr std::uint32_t kColumns = 24;

std::vector<std::uint32_t> some_cells(std::size_t count, unsigned seed) {
  std::vector<std::uint32_t> cells(kColumns * 20);
  for (std::uint32_t k = 0; k < cells.size(); ++k) cells[k] = k;
  std::shuffle(cells.begin(), cells.end(), std::mt19937(seed));
  cells.resize(count);
  return cells;
}

/// Of a block halved at its middle along x (even levels) or y: nothing before the middle lies beyond what is
/// after it.
void expect_halves(const std::uint32_t* cells, std::size_t count, std::uint32_t level) {
  if (count < 2) return;
  const auto along = [&](std::uint32_t c) { return level % 2 == 0 ? c % kColumns : c / kColumns; };
  const std::size_t half = count / 2;
  std::uint32_t most = 0, least = ~0u;
  for (std::size_t k = 0; k < half; ++k) most = std::max(most, along(cells[k]));
  for (std::size_t k = half; k < count; ++k) least = std::min(least, along(cells[k]));
  EXPECT_LE(most, least) << "level " << level << ", " << count << " cells";
  expect_halves(cells, half, level + 1);
  expect_halves(cells + half, count - half, level + 1);
}

TEST(HalvedOrder, EveryBlockIsHalvedAlongTheNextAxis) {
  for (const std::size_t count : {1u, 2u, 7u, 36u, 64u, 480u}) {
    auto cells = some_cells(count, 3);
    halve_in_turn(cells.data(), static_cast<std::uint32_t>(count), kColumns);
    expect_halves(cells.data(), count, 0);
    auto sorted = cells, expected = some_cells(count, 3);
    std::sort(sorted.begin(), sorted.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(sorted, expected);
  }
}

TEST(HalvedOrder, DoesNotDependOnTheOrderBefore) {
  auto a = some_cells(100, 5), b = a;
  std::reverse(b.begin(), b.end());
  halve_in_turn(a.data(), 100, kColumns);
  halve_in_turn(b.data(), 100, kColumns);
  EXPECT_EQ(a, b);
}

}  // namespace
}  // namespace capcon
