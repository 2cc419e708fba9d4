#include "tiling/equal_cells.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace capcon {
namespace {

// Neighbours are sought as far as this many mean spacings.
constexpr double kReach = 3;

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

EqualCells::EqualCells(const GaussianTiling& tiling, const std::vector<std::uint32_t>& colours,
                       const TiedPoints& points)
    : target_(1.0 / points.points_per_tile), per_tile_(points.points_per_tile) {
  for (std::uint32_t cell = 0; cell < tiling.size(); ++cell) {
    const auto& tile = points.tiles[tile_of(tiling, colours, points.colours, cell)];
    free_point_.insert(free_point_.end(), tile.begin(), tile.end());
    const glm::ivec2 at = tiling.cell(cell);
    around_.emplace_back();
    for (int k = 0; k < 9; ++k) around_.back()[k] = tiling.index(at.x + k % 3 - 1, at.y + k / 3 - 1);
  }
  neighbours_.resize(site_count());
  weights_.resize(site_count());
  cells_.resize(site_count());
}

void EqualCells::find_neighbours(const TiedPoints& points) {
  const double reach2 = std::min(1.0, kReach * kReach * target_);
  for (std::size_t site = 0; site < site_count(); ++site) {
    std::vector<Neighbour>& list = neighbours_[site];
    list.clear();
    const glm::dvec2 here = points.free[free_point_[site]].position;
    for (int k = 0; k < 9; ++k) {
      const std::size_t first = around_[site / per_tile_][k] * per_tile_;
      const glm::dvec2 shift(k % 3 - 1, k / 3 - 1);
      for (std::size_t other = first; other < first + per_tile_; ++other) {
        if (k == 4 && other == site) continue;  // not itself, but its images on a small torus are neighbours
        const glm::dvec2 offset = points.free[free_point_[other]].position + shift - here;
        const double distance2 = glm::dot(offset, offset);
        if (distance2 < reach2) list.push_back({offset, distance2, std::uint32_t(other)});
      }
    }
    std::stable_sort(list.begin(), list.end(),
                     [](const Neighbour& a, const Neighbour& b) { return a.distance2 < b.distance2; });
  }
}

void EqualCells::compute_cells() {
  for (std::size_t site = 0; site < site_count(); ++site)
    clip_power_cell(neighbours_[site], weights_[site], weights_, cells_[site]);
}

double EqualCells::residual2() const {
  double sum = 0;
  for (const PowerCell& cell : cells_) sum += (cell.area - target_) * (cell.area - target_);
  return sum;
}

double EqualCells::least_area() const {
  double least = target_;
  for (const PowerCell& cell : cells_) least = std::min(least, cell.area);
  return least;
}

// Solves L d = target - area by conjugate gradients with L's diagonal as preconditioner; L is the Laplacian
// of the cells' adjacency with the walls' slopes, the Jacobian of the areas by the weights.
std::vector<double> EqualCells::newton_direction() const {
  const std::size_t n = site_count();
  std::vector<double> x(n), r(n), z(n), p(n), lp(n), diagonal(n);
  double mean = 0;
  for (std::size_t i = 0; i < n; ++i) {
    r[i] = target_ - cells_[i].area;
    mean += r[i] / double(n);
    for (const PowerCell::Wall& wall : cells_[i].walls)
      if (wall.site != i) diagonal[i] += wall.slope;
    diagonal[i] = std::max(diagonal[i], 1e-12);
  }
  for (std::size_t i = 0; i < n; ++i) r[i] -= mean;  // areas sum to the torus but for rounding
  for (std::size_t i = 0; i < n; ++i) z[i] = r[i] / diagonal[i];
  p = z;
  double rz = dot(r, z);
  const double enough = 1e-6 * rz;
  for (int step = 0; step < 400 && rz > enough && rz > 0; ++step) {
    for (std::size_t i = 0; i < n; ++i) {
      double sum = diagonal[i] * p[i];
      for (const PowerCell::Wall& wall : cells_[i].walls)
        if (wall.site != i) sum -= wall.slope * p[wall.site];
      lp[i] = sum;
    }
    const double curvature = dot(p, lp);
    if (!(curvature > 0)) break;
    const double alpha = rz / curvature;
    for (std::size_t i = 0; i < n; ++i) x[i] += alpha * p[i], r[i] -= alpha * lp[i];
    for (std::size_t i = 0; i < n; ++i) z[i] = r[i] / diagonal[i];
    const double next = dot(r, z);
    for (std::size_t i = 0; i < n; ++i) p[i] = z[i] + next / rz * p[i];
    rz = next;
  }
  return x;
}

void EqualCells::solve(const TiedPoints& points, double tolerance) {
  find_neighbours(points);
  compute_cells();
  if (least_area() <= 0.05 * target_) {  // the last weights do not suit: start from the Voronoi cells
    std::fill(weights_.begin(), weights_.end(), 0.0);
    compute_cells();
  }
  for (int step = 0; step < 50; ++step) {
    double worst = 0;
    for (const PowerCell& cell : cells_) worst = std::max(worst, std::abs(cell.area - target_));
    if (worst <= tolerance * target_) break;
    const std::vector<double> direction = newton_direction(), before = weights_;
    const double r2 = residual2(), floor = 0.5 * least_area();
    for (double alpha = 1; alpha > 1e-4; alpha /= 2) {
      for (std::size_t i = 0; i < weights_.size(); ++i) weights_[i] = before[i] + alpha * direction[i];
      compute_cells();
      if (least_area() >= floor && residual2() <= (1 - alpha / 2) * (1 - alpha / 2) * r2 * 1.0001) break;
    }
  }
}

double EqualCells::energy() const {
  double sum = 0;
  for (const PowerCell& cell : cells_) sum += cell.second_moment;
  return sum * double(per_tile_) / double(site_count());
}

}  // namespace capcon
