#pragma once

#include <cstdint>
#include <vector>

#include "points/ccvt_cells.h"
#include "points/ccvt_exchange.h"

namespace capcon {

/// The pairs of sites whose bounding circles overlap or nearly so, in batches: the pairs of one batch share
/// no site, so they may be worked on in any order, or at once, with the same result.
class CcvtPairs {
 public:
  /// Where the points of both sides stood when the pair was looked at last. A trade gains only if p of i lies
  /// farther along the direction from i to j than q of j. As long as no point has come that is farther out,
  /// and the sites have moved too little to turn the direction enough, there is nothing to gain.
  struct Pair {
    std::uint32_t i, j;
    CcvtFront front{};
    double travel = 0;  ///< of both sites together, then
  };

  /// `keeps_account`: of what comes and goes, so that most pairs need no look at their points although their
  /// sites have changed; else any change calls for a look, which is cheaper for small capacities.
  explicit CcvtPairs(bool keeps_account) : keeps_account_(keeps_account) {}

  /// Finds the pairs of sites whose circle moved or grew beyond the slack left for it.
  void refresh(const CcvtCells& cells);

  std::size_t batches() const { return start_.empty() ? 0 : start_.size() - 1; }
  std::size_t batch_size(std::size_t batch) const { return start_[batch + 1] - start_[batch]; }
  Pair& pair(std::size_t batch, std::size_t k) { return pairs_[start_[batch] + k]; }

  /// Whether nothing can be gained from the pair, without a look at its points.
  bool is_settled(const CcvtCells& cells, const Pair& pair) const;
  /// The points of site i in these slots are new: its pairs other than `than` take note. Writes only what
  /// belongs to site i.
  void note_arrivals(const CcvtCells& cells, std::uint32_t i, const std::vector<CcvtCandidate>& slots,
                     std::uint32_t count, const Pair& than);
  /// Site i may have any points, or another centre: its pairs, other than `than`, must be looked at.
  void forget(std::uint32_t i, const Pair* than);

 private:
  struct Circle {
    TorusPoint centre;
    float radius = -1;
  };
  static Circle circle_of(const CcvtSite& site);
  std::vector<std::uint32_t> stale_sites(const CcvtCells& cells);
  void find(const std::vector<std::uint32_t>& stale);
  void batch_up(std::size_t known);

  bool keeps_account_;
  std::vector<Circle> circles_;
  std::vector<Pair> pairs_;
  std::vector<std::uint8_t> batch_;     ///< of each pair
  std::vector<std::size_t> start_;      ///< of each batch in pairs_
  std::vector<std::uint32_t> first_;    ///< of each site in of_site_
  std::vector<std::uint32_t> of_site_;  ///< the pairs of each site
};

}  // namespace capcon
