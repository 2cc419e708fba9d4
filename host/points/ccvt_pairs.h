#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "points/ccvt_cells.h"

namespace capcon {

/// The pairs of sites whose bounding circles overlap or nearly so, in batches: the pairs of one batch share
/// no site, so they may be worked on in any order, or at once, with the same result.
class CcvtPairs {
 public:
  struct Pair {
    std::uint32_t i, j;
    std::uint32_t checked;  ///< the time when nothing was left to gain
  };

  /// Finds all pairs if some circle moved or grew beyond the slack left for it. New pairs count as checked at
  /// `time`. Returns whether it did.
  bool refresh(const CcvtCells& cells, std::uint32_t time);

  std::size_t batches() const { return start_.empty() ? 0 : start_.size() - 1; }
  Pair* begin(std::size_t batch) { return pairs_.data() + start_[batch]; }
  Pair* end(std::size_t batch) { return pairs_.data() + start_[batch + 1]; }

 private:
  struct Circle {
    glm::dvec2 centre;  ///< units of the torus
    double radius = 0;
    double slack = 0;  ///< how far centre and radius together may have changed
  };
  static Circle circle_of(const CcvtSite& site);
  bool is_stale(const CcvtCells& cells) const;
  void find();
  void batch_up();

  std::vector<Circle> circles_;
  std::vector<Pair> pairs_;
  std::vector<std::size_t> start_;
};

}  // namespace capcon
