#include "points/ensemble_start.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "base/hash.h"
#include "base/morton.h"

namespace capcon {
namespace {

constexpr std::uint64_t kDealStream = 0x6465616c, kScrambleStream = 0x6f77656e;

struct Grid {
  std::uint32_t columns, rows;
};

/// A grid whose cells can be dealt to sets of n, nearly square, with about as many sets as are wished.
Grid choose_grid(std::uint32_t n, double wished) {
  Grid best{n, 1};
  double least = 1e300;
  const auto side = static_cast<std::uint32_t>(std::sqrt(wished * n));
  for (std::uint32_t a = std::max(1u, side / 2); a <= 4 * side; ++a) {
    for (std::uint32_t b = a; b <= a + a / 4; ++b) {
      const std::uint64_t count = std::uint64_t(a) * b;
      if (count % n != 0) continue;
      const double sets = static_cast<double>(count / n);
      const double cost = std::abs(std::log(sets / wished)) + 4 * std::log(double(b) / a);
      if (cost < least) least = cost, best = {b, a};
    }
  }
  return best;
}

/// The first `bits` digits of the Sobol' sequence's point t, second dimension: its direction numbers are the
/// rows of Pascal's triangle modulo 2.
std::uint32_t second_digits(std::uint32_t t, std::uint32_t bits) {
  std::uint32_t value = 0, direction = 0x80000000u;
  for (; t != 0; t >>= 1, direction ^= direction >> 1) value ^= (t & 1) != 0 ? direction : 0;
  return value >> (32 - bits);
}

std::uint32_t first_digits(std::uint32_t t, std::uint32_t bits) {
  std::uint32_t value = 0;
  for (std::uint32_t k = 0; k < bits; ++k) value |= (t >> k & 1) << (bits - 1 - k);
  return value;
}

/// Each digit of x flipped or not, by a hash of the digits before it: Owen's nested scrambling.
std::uint32_t scramble(std::uint32_t x, std::uint32_t bits, std::uint64_t seed, std::uint64_t axis) {
  std::uint32_t flips = 0;
  for (std::uint32_t k = 0; k < bits; ++k) {
    const std::uint64_t before = x >> (bits - k), place = std::uint64_t(1) << k;  // a tree's nodes by number
    flips |= static_cast<std::uint32_t>(mix64(seed, kScrambleStream + axis, place + before) & 1)
             << (bits - 1 - k);
  }
  return x ^ flips;
}

/// Of each side of a net's grid.
std::uint32_t net_bits(std::uint32_t n, std::uint32_t wished_sets) {
  std::uint32_t bits = 1;
  while ((std::uint64_t(1) << (2 * bits)) < std::uint64_t(n) * wished_sets) ++bits;
  return bits;
}

bool is_power_of_two(std::uint32_t n) {
  return (n & (n - 1)) == 0;
}

Ensemble cosets_of_a_net(std::uint32_t n, std::uint32_t wished_sets, std::uint64_t seed) {
  const std::uint32_t bits = net_bits(n, wished_sets), side = 1u << bits;
  Ensemble e{side, side, side * side / n, {}};
  e.cells.reserve(std::size_t(side) * side);
  std::vector<char> dealt(std::size_t(side) * side);
  for (std::uint32_t first = 0; first < dealt.size(); ++first) {
    if (dealt[first] != 0) continue;
    for (std::uint32_t t = 0; t < n; ++t) {
      const std::uint32_t x = first % side ^ first_digits(t, bits), y = first / side ^ second_digits(t, bits);
      dealt[x + std::size_t(side) * y] = 1;
      e.cells.push_back(scramble(x, bits, seed, 0) + side * scramble(y, bits, seed, 1));
    }
  }
  return e;
}

Ensemble blocks_of_a_curve(std::uint32_t n, std::uint32_t wished_sets, std::uint64_t seed) {
  const Grid grid = choose_grid(n, wished_sets);
  Ensemble e{grid.columns, grid.rows, grid.columns * grid.rows / n, {}};
  std::vector<std::uint32_t> near(std::size_t(grid.columns) * grid.rows), deal(e.sets);
  std::iota(near.begin(), near.end(), 0u);
  std::sort(near.begin(), near.end(), [&](std::uint32_t a, std::uint32_t b) {
    return morton_code(a % e.columns, a / e.columns) < morton_code(b % e.columns, b / e.columns);
  });
  e.cells.resize(near.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    std::iota(deal.begin(), deal.end(), 0u);
    for (std::uint32_t k = e.sets; k > 1; --k)
      std::swap(deal[k - 1], deal[mix64(seed, kDealStream + i, k) % k]);
    for (std::uint32_t s = 0; s < e.sets; ++s)
      e.cells[std::size_t(s) * n + i] = near[std::size_t(i) * e.sets + deal[s]];
  }
  return e;
}

}  // namespace

Ensemble start_ensemble(std::uint32_t n, std::uint32_t wished_sets, std::uint64_t seed) {
  return is_power_of_two(n) ? cosets_of_a_net(n, wished_sets, seed) : blocks_of_a_curve(n, wished_sets, seed);
}

std::uint32_t sets_of_start(std::uint32_t n, std::uint32_t wished_sets) {
  if (is_power_of_two(n)) return (1u << (2 * net_bits(n, wished_sets))) / n;
  const Grid grid = choose_grid(n, wished_sets);
  return grid.columns * grid.rows / n;
}

}  // namespace capcon
