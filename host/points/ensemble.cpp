#include "points/ensemble.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/error.h"
#include "base/hash.h"
#include "base/parallel.h"

namespace capcon {
namespace {

constexpr std::uint64_t kDealStream = 0x656e73656d, kPairStream = kDealStream + 1;
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

/// Two sets that swap cells until neither gains.
class Pair {
 public:
  Pair(const std::vector<glm::vec2>& centres, std::uint32_t* a, std::uint32_t* b, std::uint32_t n)
      : cells_{a, b}, n_(n) {
    const std::uint32_t m = 2 * n;
    distance_.resize(std::size_t(m) * m);
    std::vector<float> x(m), y(m);
    for (std::uint32_t i = 0; i < m; ++i) {
      const glm::vec2 c = centres[cell(i)];
      x[i] = c.x;
      y[i] = c.y;
    }
    for (std::uint32_t i = 0; i < m; ++i) {
      float* row = &distance_[std::size_t(i) * m];
      for (std::uint32_t j = 0; j < m; ++j)
        row[j] = std::sqrt((x[i] - x[j]) * (x[i] - x[j]) + (y[i] - y[j]) * (y[i] - y[j]));
    }
    // Where each place's point was at first: the matrix stays, places move.
    at_.resize(m);
    std::iota(at_.begin(), at_.end(), 0u);
    for (int s = 0; s < 2; ++s) {
      sum_[s].assign(m, 0);
      for (std::uint32_t p = 0; p < m; ++p) {
        const float* row = &distance_[std::size_t(p) * m + s * n];
        sum_[s][p] = std::accumulate(row, row + n, 0.0f);
      }
    }
  }

  /// Swaps while there is a gain, at most three passes; whether there was any.
  bool run() {
    const std::vector<std::uint32_t> before = cells();
    bool any = true, ever = false;
    for (int pass = 0; any && pass < 3; ++pass) {
      any = false;
      for (std::uint32_t i = 0; i < n_; ++i) any = best_swap(i) || any;
      ever = ever || any;
    }
    for (std::uint32_t i = 0; ever && i < 2 * n_; ++i) cell(i) = before[at_[i]];
    return ever;
  }

 private:
  std::uint32_t& cell(std::uint32_t place) {
    return cells_[place < n_ ? 0 : 1][place < n_ ? place : place - n_];
  }
  std::vector<std::uint32_t> cells() {
    std::vector<std::uint32_t> all(2 * n_);
    for (std::uint32_t i = 0; i < 2 * n_; ++i) all[i] = cell(i);
    return all;
  }

  /// The swap of place i of the first set with the place of the second that gains most.
  bool best_swap(std::uint32_t i) {
    const std::uint32_t m = 2 * n_, p = at_[i];
    const float* row = &distance_[std::size_t(p) * m];
    const float own = sum_[1][p] - sum_[0][p];
    float most = 1e-4f;  // below this it is rounding
    std::uint32_t chosen = m;
    for (std::uint32_t j = n_; j < m; ++j) {
      const std::uint32_t q = at_[j];
      const float gain = own + sum_[0][q] - sum_[1][q] - 2 * row[q];
      if (gain > most) most = gain, chosen = j;
    }
    if (chosen == m) return false;
    const std::uint32_t q = at_[chosen];
    const float* other = &distance_[std::size_t(q) * m];
    for (std::uint32_t k = 0; k < m; ++k) {
      const float change = other[k] - row[k];
      sum_[0][k] += change;
      sum_[1][k] -= change;
    }
    std::swap(at_[i], at_[chosen]);
    return true;
  }

  std::uint32_t* cells_[2];
  std::uint32_t n_;
  std::vector<float> distance_;
  std::vector<std::uint32_t> at_;
  std::vector<float> sum_[2];  ///< by point: the sum of its distances to each set
};

glm::dvec2 centre(const Ensemble& e, std::uint32_t cell) {
  return {(cell % e.columns + 0.5) / e.columns, (cell / e.columns + 0.5) / e.rows};
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
  std::vector<glm::vec2> centres(e.cells.size());
  for (std::uint32_t c = 0; c < centres.size(); ++c)
    centres[c] = glm::vec2(into_domain(options.domain, centre(e, c)));

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
      Pair pair(centres, &e.cells[std::size_t(order[2 * k]) * n], &e.cells[std::size_t(order[2 * k + 1]) * n],
                n);
      changed[k] = pair.run() ? 1 : 0;
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
