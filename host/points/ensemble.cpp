#include "points/ensemble.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/error.h"
#include "base/hash.h"
#include "base/morton.h"
#include "base/parallel.h"
#include "points/cell_swaps.h"

namespace capcon {
namespace {

constexpr std::uint64_t kDealStream = 0x656e73656d, kPairStream = kDealStream + 1,
                        kPartStream = kDealStream + 0x100000000;
constexpr double kSets = 64;  // wished; more cells are finer, and take longer

struct Grid {
  std::uint32_t columns, rows;
};

/// A grid whose cells can be dealt to sets of n, nearly square, with about kSets sets.
Grid choose_grid(std::uint32_t n) {
  Grid best{n, 1};
  double least = 1e300;
  const auto side = static_cast<std::uint32_t>(std::sqrt(kSets * n));
  for (std::uint32_t a = std::max(1u, side / 2); a <= 4 * side; ++a) {
    for (std::uint32_t b = a; b <= a + a / 4; ++b) {
      const std::uint64_t count = std::uint64_t(a) * b;
      if (count % n != 0) continue;
      const double sets = static_cast<double>(count / n);
      const double cost = std::abs(std::log(sets / kSets)) + 4 * std::log(double(b) / a);
      if (cost < least) least = cost, best = {b, a};
    }
  }
  return best;
}

/// Fisher and Yates, by hash.
template <class T>
void shuffle(std::vector<T>& items, std::uint64_t seed, std::uint64_t stream) {
  for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[mix64(seed, stream, i) % i]);
}

glm::dvec2 centre(const Ensemble& e, std::uint32_t cell) {
  return {(cell % e.columns + 0.5) / e.columns, (cell / e.columns + 0.5) / e.rows};
}

std::vector<glm::vec2> centres_of(const Ensemble& e, EnsembleDomain domain) {
  std::vector<glm::vec2> centres(e.cells.size());
  for (std::uint32_t c = 0; c < centres.size(); ++c)
    centres[c] = glm::vec2(into_domain(domain, centre(e, c)));
  return centres;
}

}  // namespace

glm::dvec2 into_domain(EnsembleDomain domain, glm::dvec2 u) {
  if (domain == EnsembleDomain::square) return u;
  const glm::dvec2 p = 2.0 * u - 1.0;
  if (p.x == 0 && p.y == 0) return {0, 0};
  const bool wide = std::abs(p.x) > std::abs(p.y);
  const double radius = wide ? p.x : p.y, angle = std::numbers::pi / 4 * (wide ? p.y / p.x : p.x / p.y);
  return wide ? radius * glm::dvec2(std::cos(angle), std::sin(angle))
              : radius * glm::dvec2(std::sin(angle), std::cos(angle));
}

Ensemble make_ensemble(const EnsembleOptions& options) {
  const std::uint32_t n = options.points;
  if (n == 0 || n > kMostEnsemblePoints) {
    throw InputError(
        fmt::format("an ensemble has sets of 1 to {} points, and {} are asked for", kMostEnsemblePoints, n));
  }
  Ensemble e;
  const Grid grid = choose_grid(n);
  e.columns = grid.columns;
  e.rows = grid.rows;
  e.cells.resize(std::size_t(grid.columns) * grid.rows);
  e.sets = static_cast<std::uint32_t>(e.cells.size() / n);
  std::iota(e.cells.begin(), e.cells.end(), 0u);
  shuffle(e.cells, options.seed, kDealStream);
  const std::vector<glm::vec2> centres = centres_of(e, options.domain);

  // Rounds of a tournament: every set meets another one in each. It is over when a round for every set has
  // changed nothing.
  const double pair_cost = 4.0 * n * n;
  const auto rounds = static_cast<std::uint32_t>(
      std::clamp(options.effort / (pair_cost * std::max(1u, e.sets / 2)), 8.0, 8.0 * e.sets));
  const auto grain =
      static_cast<std::size_t>(std::max(1.0, 1e6 / pair_cost));  // a thread costs about as much
  std::vector<std::uint32_t> order(e.sets);
  std::vector<char> changed(e.sets / 2);
  std::uint32_t idle = 0;
  for (std::uint32_t round = 0; e.sets > 1 && round < rounds && idle < e.sets; ++round) {
    std::iota(order.begin(), order.end(), 0u);
    shuffle(order, options.seed, kPairStream + round);
    const auto meet = [&](std::size_t k) {
      changed[k] = swap_cells(centres, &e.cells[std::size_t(order[2 * k]) * n],
                              &e.cells[std::size_t(order[2 * k + 1]) * n], n)
                       ? 1
                       : 0;
    };
    if (grain >= changed.size()) {
      for (std::size_t k = 0; k < changed.size(); ++k) meet(k);
    } else {
      parallel_for(changed.size(), meet, grain);
    }
    idle = std::find(changed.begin(), changed.end(), 1) == changed.end() ? idle + 1 : 0;
  }
  return e;
}

void deal_parts(Ensemble& e, EnsembleDomain domain, std::uint32_t parts) {
  const auto n = static_cast<std::uint32_t>(e.cells.size() / e.sets), points = n / parts;
  if (parts == 1 || points == 1) return;
  const std::vector<glm::vec2> centres = centres_of(e, domain);
  constexpr int kSweeps = 6;
  parallel_for(e.sets, [&](std::size_t s) {
    // Every part begins with one of each `parts` cells that lie near each other.
    std::uint32_t* const set = &e.cells[s * n];
    std::vector<std::uint32_t> near(set, set + n), deal(parts);
    std::sort(near.begin(), near.end(), [&](std::uint32_t a, std::uint32_t b) {
      return morton_code(a % e.columns, a / e.columns) < morton_code(b % e.columns, b / e.columns);
    });
    for (std::uint32_t i = 0; i < points; ++i) {
      std::iota(deal.begin(), deal.end(), 0u);
      shuffle(deal, s, kPartStream + i);
      for (std::uint32_t p = 0; p < parts; ++p) set[p * points + i] = near[i * parts + deal[p]];
    }
    bool any = true;
    for (int sweep = 0; any && sweep < kSweeps; ++sweep) {
      any = false;
      for (std::uint32_t a = 0; a < parts; ++a)
        for (std::uint32_t b = a + 1; b < parts; ++b)
          any = swap_cells(centres, set + a * points, set + b * points, points) || any;
    }
  });
}

double mean_distance_within(const Ensemble& e, EnsembleDomain domain) {
  const std::size_t n = e.cells.size() / e.sets;
  double sum = 0;
  for (std::uint32_t s = 0; s < e.sets; ++s) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        const glm::dvec2 d = into_domain(domain, centre(e, e.cells[s * n + i])) -
                             into_domain(domain, centre(e, e.cells[s * n + j]));
        sum += std::sqrt(d.x * d.x + d.y * d.y);
      }
    }
  }
  return sum / (static_cast<double>(n) * static_cast<double>(n) * e.sets);
}

}  // namespace capcon
