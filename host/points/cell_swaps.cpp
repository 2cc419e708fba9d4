#include "points/cell_swaps.h"

#include <cmath>
#include <numeric>

namespace capcon {
namespace {

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

}  // namespace

bool swap_cells(const std::vector<glm::vec2>& centres, std::uint32_t* a, std::uint32_t* b, std::uint32_t n) {
  return Pair(centres, a, b, n).run();
}

}  // namespace capcon
