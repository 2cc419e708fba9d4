#include "tiling/even_points.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <limits>
#include <utility>

#include "base/parallel.h"

namespace capcon {
namespace {

constexpr double kMomentWeight = 20;
constexpr double kMargin = 1e-3;  // of a cell: no point on the line between two
constexpr int kMostPasses = 20;
constexpr double kFarthest = 0.02;  // squared ways longer by this are not worth a look

/// column[row] of the assignment of least cost: one row after another by a shortest augmenting path, with
/// potentials that keep the costs left over at 0 or above.
std::vector<std::uint32_t> assign(const std::vector<double>& cost, std::size_t n) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<double> row_potential(n + 1), column_potential(n + 1), least(n + 1);
  std::vector<std::size_t> row_of(n + 1, 0), before(n + 1);  // rows and columns from 1; 0: none
  std::vector<bool> done(n + 1);
  for (std::size_t row = 1; row <= n; ++row) {
    std::size_t column = 0;
    row_of[0] = row;
    std::fill(least.begin(), least.end(), kFar);
    std::fill(done.begin(), done.end(), false);
    while (row_of[column] != 0) {
      done[column] = true;
      const std::size_t from = row_of[column];
      std::size_t next = 0;
      double step = kFar;
      for (std::size_t c = 1; c <= n; ++c) {
        if (done[c]) continue;
        const double left = cost[(from - 1) * n + c - 1] - row_potential[from] - column_potential[c];
        if (left < least[c]) least[c] = left, before[c] = column;
        if (least[c] < step) step = least[c], next = c;
      }
      for (std::size_t c = 0; c <= n; ++c) {
        if (done[c]) {
          row_potential[row_of[c]] += step;
          column_potential[c] -= step;
        } else {
          least[c] -= step;
        }
      }
      column = next;
    }
    for (; column != 0; column = before[column]) row_of[column] = row_of[before[column]];
  }
  std::vector<std::uint32_t> result(n);
  for (std::size_t c = 1; c <= n; ++c) result[row_of[c] - 1] = std::uint32_t(c - 1);
  return result;
}

/// Sums over a tile's points of what has a mean of 0 over the tile: x, y, their squares and their product.
using Moments = std::array<double, 5>;

Moments moments(glm::dvec2 p) {
  const glm::dvec2 d = p - 0.5;
  return {d.x, d.y, d.x * d.x - 1 / 12.0, d.y * d.y - 1 / 12.0, d.x * d.y};
}

/// The points of a class and their cells. What is lowered is the sum of squared ways from where points were,
/// plus kMomentWeight / n times the squared sums of every tile's moments: a tile alone then integrates what
/// is smooth, whatever its neighbours are.
class Dealing {
 public:
  Dealing(const TiedPoints& points, const EvenCells& cells, int tile_class, double settled)
      : cells_(cells),
        weight_(settled * kMomentWeight / points.points_per_tile),
        margin_(0.5 * settled),
        sums_(points.tiles.size()) {
    for (std::uint32_t i = 0; i < points.free.size(); ++i) {
      if (cells.class_of(points.free[i].region) != tile_class) continue;
      members.push_back(i);
      points_.push_back(points.free[i]);
    }
    const std::size_t n = members.size();
    cost_.resize(n * n);
    for (std::size_t k = 0; k < n; ++k)
      for (std::uint32_t c = 0; c < n; ++c)
        cost_[k * n + c] = cells.distance2(points_[k].region, points_[k].position, c);
    cell_ = assign(cost_, n);
    for (std::size_t k = 0; k < n; ++k) add(sums_[points_[k].region], moments(place(k)), 1);
    for (int pass = 0; pass < kMostPasses && swap_pairs(); ++pass) {
    }
  }

  std::vector<std::uint32_t> members;  ///< indices of free points
  glm::dvec2 place(std::size_t k) const { return place(k, cell_[k]); }

 private:
  glm::dvec2 place(std::size_t k, std::uint32_t cell) const {
    return cells_.nearest(points_[k].region, points_[k].position, cell, std::max(margin_, kMargin));
  }
  static void add(Moments& sums, const Moments& m, double sign) {
    for (std::size_t j = 0; j < m.size(); ++j) sums[j] += sign * m[j];
  }
  static double squares(const Moments& m) {
    double sum = 0;
    for (const double v : m) sum += v * v;
    return sum;
  }

  bool swap_pairs() {
    const std::size_t n = points_.size();
    bool any = false;
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t l = k + 1; l < n; ++l) {
        const double way = cost_[k * n + cell_[l]] + cost_[l * n + cell_[k]] - cost_[k * n + cell_[k]] -
                           cost_[l * n + cell_[l]];
        if (way > kFarthest) continue;
        const std::uint32_t t = points_[k].region, u = points_[l].region;
        Moments in_t = sums_[t], in_u = sums_[u];
        Moments& other = t == u ? in_t : in_u;
        add(in_t, moments(place(k, cell_[k])), -1), add(in_t, moments(place(k, cell_[l])), 1);
        add(other, moments(place(l, cell_[l])), -1), add(other, moments(place(l, cell_[k])), 1);
        double change = squares(in_t) - squares(sums_[t]);
        if (t != u) change += squares(in_u) - squares(sums_[u]);
        if (way + weight_ * change > -1e-9) continue;
        sums_[t] = in_t;
        if (t != u) sums_[u] = in_u;
        std::swap(cell_[k], cell_[l]);
        any = true;
      }
    return any;
  }

  const EvenCells& cells_;
  double weight_, margin_;
  std::vector<TiedPoints::FreePoint> points_;
  std::vector<double> cost_;
  std::vector<std::uint32_t> cell_;
  std::vector<Moments> sums_;  ///< by tile
};

}  // namespace

void make_even(TiedPoints& points, double settled) {
  const EvenCells cells(points.colours, points.points_per_tile);
  std::vector<glm::dvec2> places(points.free.size());
  parallel_for(3, [&](std::size_t tile_class) {
    const Dealing dealing(points, cells, int(tile_class), settled);
    for (std::size_t k = 0; k < dealing.members.size(); ++k) places[dealing.members[k]] = dealing.place(k);
  });
  for (std::size_t i = 0; i < places.size(); ++i) points.free[i].position = places[i];
}

void keep_in_cells(TiedPoints& moved, const TiedPoints& placed) {
  const EvenCells cells(placed.colours, placed.points_per_tile);
  for (std::size_t i = 0; i < placed.free.size(); ++i) {
    const TiedPoints::FreePoint& p = placed.free[i];
    const EvenCells::Cell cell = cells.cell(p.region, p.position);
    const glm::dvec2 margin = kMargin * cell.size;
    moved.free[i].position =
        cell.twin != 0 ? p.position
                       : glm::clamp(moved.free[i].position, cell.low + margin, cell.low + cell.size - margin);
  }
}

}  // namespace capcon
