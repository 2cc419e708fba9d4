#include "points/lloyd.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "base/parallel.h"
#include "points/bounded_cells.h"
#include "points/checks.h"
#include "points/measure.h"
#include "points/site_tree.h"
#include "points/voronoi.h"

namespace capcon {

namespace {

glm::dvec2 wrapped(glm::dvec2 p) {
  p -= glm::floor(p);
  return {p.x < 1 ? p.x : 0, p.y < 1 ? p.y : 0};  // a tiny negative coordinate rounds up to 1
}

/// That the energy of a round is at most that of the one before, but for the rounding of its sums: sites at
/// the centroids lower it for the cells that they had, and the nearest sites again.
class FallingEnergy {
 public:
  void next(double energy, double rounding) {
    if (energy_ > 0) check_step(Checked::kLloyd, energy - energy_, 1e-12 * energy_ + rounding, energy_);
    require(std::isfinite(energy), "lloyd: the energy is not finite");
    energy_ = energy;
  }

 private:
  double energy_ = 0;
};

void torus_round(Points& points, [[maybe_unused]] FallingEnergy& falling) {
  const std::vector<VoronoiCell> cells = voronoi_cells(points);
  if constexpr (kChecks) {
    double energy = 0;
    for (const VoronoiCell& cell : cells) energy += cell.second_moment;
    falling.next(energy, 1e-16);
  }
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = wrapped(points[i] + cells[i].centroid);
}

void bounded_round(Points& points, Domain domain) {
  const std::vector<CellMoments> cells = bounded_cells(points, domain);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = cells[i].centroid;
}

/// Cells made of space points.
class DiscreteCells {
 public:
  DiscreteCells(const Region& region, std::uint32_t n, std::uint64_t seed)
      : torus_(region.domain == Domain::kTorus),
        space_(spread(region, 256ull * n, seed)),
        owner_(space_.size(), 0) {}

  void round(Points& points, [[maybe_unused]] FallingEnergy& falling) {
    assign(points);
    if constexpr (kChecks) check(points, falling);
    std::vector<glm::dvec2> sum(points.size(), glm::dvec2(0));
    std::vector<std::uint32_t> count(points.size(), 0);
    for (std::size_t k = 0; k < space_.size(); ++k) {
      glm::dvec2 d = space_[k] - points[owner_[k]];
      if (torus_) d -= glm::round(d);
      sum[owner_[k]] += d;
      ++count[owner_[k]];
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (count[i] > 0) points[i] = wrapped(points[i] + sum[i] / static_cast<double>(count[i]));
    }
  }

 private:
  void check(const Points& points, FallingEnergy& falling) const {
    const SiteTree tree(points, torus_);
    double energy = 0;
    for (std::size_t k = 0; k < space_.size(); ++k) {
      const double distance2 = tree.distance2(space_[k], owner_[k]);
      require(distance2 == tree.distance2(space_[k], tree.nearest(space_[k])),
              "lloyd: a site is not the nearest");
      energy += distance2;
    }
    falling.next(energy, 1e-30 * static_cast<double>(space_.size()));
  }

  /// Each space point to its nearest site.
  void assign(const Points& points) {
    const SiteTree tree(points, torus_);
    const PeriodicVoronoi diagram(points);
    constexpr std::size_t kBlock = 4096;
    std::vector<double> apart2(points.size());  // squared distance to the nearest other site, or less
    parallel_for((points.size() + kBlock - 1) / kBlock, [&](std::size_t block) {
      PeriodicVoronoi::Scratch scratch;
      for (std::size_t k = block * kBlock; k < std::min(points.size(), (block + 1) * kBlock); ++k)
        apart2[diagram.order()[k]] = diagram.cut(diagram.order()[k], scratch);
    });
    parallel_for((space_.size() + kBlock - 1) / kBlock, [&](std::size_t block) {
      for (std::size_t k = block * kBlock; k < std::min(space_.size(), (block + 1) * kBlock); ++k) {
        // Nearer to a site than half way to the next: no other can be nearest (Hamerly 2010).
        if (4 * tree.distance2(space_[k], owner_[k]) < apart2[owner_[k]]) continue;
        owner_[k] = tree.nearest(space_[k]);
      }
    });
  }

  bool torus_;
  Points space_;
  std::vector<std::uint32_t> owner_;
};

}  // namespace

Points lloyd(const LloydOptions& options) {
  const Region& region = options.region;
  Points points = random_points(region, options.n, options.seed);
  std::unique_ptr<DiscreteCells> discrete;
  if (region.density && options.rounds > 0)
    discrete = std::make_unique<DiscreteCells>(region, options.n, options.seed);
  FallingEnergy falling;
  for (std::uint32_t round = 0; round < options.rounds; ++round) {
    if (discrete) {
      discrete->round(points, falling);
    } else if (region.domain == Domain::kTorus) {
      torus_round(points, falling);
    } else {
      bounded_round(points, region.domain);
    }
    if (options.on_progress) options.on_progress((round + 1.0) / options.rounds);
  }
  return points;
}

}  // namespace capcon
