#include "tiling/equal_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace capcon {
namespace {

// Neighbours are sought as far as this many mean spacings.
constexpr double kReach = 3;
// ... and sought again when a point has moved by this many since.
constexpr double kSearchAgain = 0.25;
constexpr double kTooSmall = 0.05;  // of the mean area
constexpr int kNewtonSteps = 12;

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
    const int side = int(tiling.side());
    const bool bounded = points.colouring == Colouring::bounded;
    for (int k = 0; k < 9; ++k) {
      const glm::ivec2 there(at.x + k % 3 - 1, at.y + k / 3 - 1);
      const bool beyond = std::min(there.x, there.y) < 0 || std::max(there.x, there.y) >= side;
      around_.back()[k] = bounded && beyond ? kNoTile : tiling.index(there.x, there.y);
    }
    if (bounded) boxes_.push_back({-glm::dvec2(at), glm::dvec2(side - at.x, side - at.y)});
  }
  neighbours_.resize(site_count());
  weights_.resize(site_count());
  clip_.resize(site_count());
  cells_.resize(site_count());
}

void EqualCells::find_neighbours(const TiedPoints& points) {
  const double reach2 = std::min(1.0, kReach * kReach * target_);
  for (std::size_t site = 0; site < site_count(); ++site) {
    std::vector<Neighbour>& list = neighbours_[site];
    list.clear();
    const glm::dvec2 here = points.free[free_point_[site]].position;
    for (int k = 0; k < 9; ++k) {
      if (around_[site / per_tile_][k] == kNoTile) continue;
      const std::size_t first = around_[site / per_tile_][k] * per_tile_;
      const glm::dvec2 shift(k % 3 - 1, k / 3 - 1);
      for (std::size_t other = first; other < first + per_tile_; ++other) {
        if (k == 4 && other == site) continue;  // not itself, but its images on a small torus are neighbours
        const glm::dvec2 offset = points.free[free_point_[other]].position + shift - here;
        if (glm::dot(offset, offset) < reach2) list.push_back({{}, 0, std::uint32_t(other), shift});
      }
    }
  }
  searched_at_ = points.free;
}

void EqualCells::place_neighbours(const TiedPoints& points) {
  double moved2 = 0;
  for (std::size_t i = 0; i < searched_at_.size(); ++i) {
    const glm::dvec2 move = points.free[i].position - searched_at_[i].position;
    moved2 = std::max(moved2, glm::dot(move, move));
  }
  if (searched_at_.empty() || moved2 > kSearchAgain * kSearchAgain * target_) find_neighbours(points);
  for (std::size_t site = 0; site < site_count(); ++site) {
    std::vector<Neighbour>& list = neighbours_[site];
    const glm::dvec2 here = points.free[free_point_[site]].position;
    if (!boxes_.empty()) {
      const SiteBox& square = boxes_[site / per_tile_];
      clip_[site] = {glm::max(square.low - here, -1.0), glm::min(square.high - here, 1.0)};
    }
    for (std::size_t k = 0; k < list.size();
         ++k) {  // insertion sort: the list is nearly sorted from the last time
      Neighbour n = list[k];
      n.offset = points.free[free_point_[n.site]].position + n.tile - here;
      n.distance2 = glm::dot(n.offset, n.offset);
      std::size_t at = k;
      for (; at > 0 && list[at - 1].distance2 > n.distance2; --at) list[at] = list[at - 1];
      list[at] = n;
    }
  }
}

void EqualCells::compute_cells() {
  for (std::size_t site = 0; site < site_count(); ++site)
    clip_power_cell(neighbours_[site], weights_[site], weights_, cells_[site], clip_[site]);
}

double EqualCells::residual2() const {
  double sum = 0;
  for (const PowerCell& cell : cells_) sum += (cell.area - target_) * (cell.area - target_);
  return sum;
}

double EqualCells::worst_error() const {
  double worst = 0;
  for (const PowerCell& cell : cells_) worst = std::max(worst, std::abs(cell.area - target_));
  return worst;
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
  place_neighbours(points);
  compute_cells();
  if (least_area() <= kTooSmall * target_) use_voronoi_cells();  // the last weights do not suit any more
  for (int step = 0; step < kNewtonSteps && worst_error() > tolerance * target_; ++step)
    if (!newton_step()) return use_voronoi_cells();
}

void EqualCells::use_voronoi_cells() {
  std::fill(weights_.begin(), weights_.end(), 0.0);
  compute_cells();
}

bool EqualCells::newton_step() {
  const std::vector<double> direction = newton_direction(), before = weights_;
  const double r2 = residual2(), floor = 0.5 * least_area();
  for (double alpha = 1; alpha > 0.01; alpha /= 2) {
    for (std::size_t i = 0; i < weights_.size(); ++i) weights_[i] = before[i] + alpha * direction[i];
    compute_cells();
    if (least_area() >= floor && residual2() <= (1 - alpha / 2) * (1 - alpha / 2) * r2) return true;
  }
  return false;
}

double EqualCells::energy() const {
  double sum = 0;
  for (const PowerCell& cell : cells_) sum += cell.second_moment;
  return sum * double(per_tile_) / double(site_count());
}

}  // namespace capcon
