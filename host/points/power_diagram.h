#pragma once

#include <span>

#include "points/power_cell.h"

namespace capcon {

/// The power diagram of weighted sites on the unit torus: cell i holds the points p with |p - x_i|^2 - w_i
/// least. Cells are cut from the unit square by the neighbours of an older diagram. That alone leaves cells
/// too large where the neighbours have changed; it shows as edges that their two cells see differently. Those
/// cells are cut again with the neighbours' neighbours too, or from a tree over all sites, until all edges
/// agree, which makes the diagram exact: cells that tile locally tile the torus. Deterministic for any number
/// of threads.
class PowerDiagram {
 public:
  struct Edge {
    SiteImage beyond;
    double length;
    glm::dvec2 middle;  ///< relative to the site
  };

  /// Cells of the sites, in [-0.5, 1.5)^2, with weights. `older` is a diagram of as many sites nearby (not
  /// this one), or null. Returns false, the diagram then useless, as soon as some cell is known to have less
  /// area than `least_area`.
  bool compute(std::span<const glm::dvec2> sites, std::span<const double> weights, const PowerDiagram* older,
               double least_area);

  std::size_t size() const { return cells_.size(); }
  /// About the site.
  const Moments& moments(std::size_t i) const { return cells_[i].moments; }
  /// Counter-clockwise; edges with images of the same site, or of other sites more than once, are among them
  /// when sites are few.
  std::span<const Edge> edges(std::size_t i) const {
    return {blocks_[i / kBlock].data() + cells_[i].begin, cells_[i].count};
  }

  static constexpr std::size_t kBlock =
      1024;  ///< cells a task; fixed, so that sums do not depend on the threads

 private:
  struct Cell {
    std::uint32_t begin = 0, count = 0;  ///< edges in the block
    Moments moments;
  };
  struct Input;
  enum class Reach { kNeighbours, kTheirNeighbours, kAll };

  void cut(const Input& input, std::uint32_t i, Reach reach, struct PowerScratch& scratch);
  bool cut_listed(const Input& input, const std::vector<std::uint32_t>& list, Reach reach, double least_area);
  std::vector<std::uint32_t> disagreeing(double tolerance) const;

  std::vector<Cell> cells_;
  std::vector<std::vector<Edge>> blocks_;
};

}  // namespace capcon
