#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "points/ccvt_cells.h"
#include "points/ccvt_circles.h"
#include "points/ccvt_exchange.h"

namespace capcon {

/// The pairs of sites whose bounding circles overlap or nearly so, in phases of tasks: the tasks of one phase
/// share no site, so they may be worked on in any order, or at once, with the same result. A task holds the
/// pairs within a block of sites, or between two blocks: first all blocks, then their borders.
class CcvtPairs {
 public:
  /// Where the points of both sides stood when the pair was looked at last. A trade gains only if p of i lies
  /// farther along the direction from i to j than q of j. As long as no point has come that is farther out,
  /// and the sites have moved too little to turn the direction enough, there is nothing to gain.
  struct Pair {
    std::uint32_t i = 0, j = 0;
    CcvtFront front{};
    double travel = 0;  ///< of both sites together, then
  };

  /// From a certain capacity on, account is kept of what comes and goes, so that most pairs need no look at
  /// their points although their sites have changed. Below, any change calls for a look, which is cheaper
  /// there.
  explicit CcvtPairs(std::uint32_t capacity);

  /// Finds the pairs of sites whose circle moved or grew beyond the slack left for it.
  void refresh(const CcvtCells& cells);

  std::size_t phases() const { return phases_.empty() ? 0 : phases_.size() - 1; }
  /// The tasks of a phase are [first_task(phase), first_task(phase + 1)).
  std::size_t first_task(std::size_t phase) const { return phases_[phase]; }
  std::span<Pair> task(std::size_t t) { return {pairs_.data() + tasks_[t], tasks_[t + 1] - tasks_[t]}; }
  std::size_t size() const { return pairs_.size(); }
  /// Pairs in all tasks of the phase.
  std::size_t size(std::size_t phase) const { return tasks_[phases_[phase + 1]] - tasks_[phases_[phase]]; }

  /// Whether nothing can be gained from the pair, without a look at its points.
  bool is_settled(const CcvtCells& cells, const Pair& pair) const;
  /// The points of site i in these slots are new: its pairs other than `than` take note. Writes only what
  /// belongs to site i.
  void note_arrivals(const CcvtCells& cells, std::uint32_t i, const std::vector<CcvtCandidate>& slots,
                     std::uint32_t count, const Pair& than);
  /// Site i may have any points, or another centre: its pairs, other than `than`, must be looked at.
  void forget(std::uint32_t i, const Pair* than);

 private:
  using Circle = CcvtCircle;
  static Circle circle_of(const CcvtSite& site);
  std::vector<std::uint32_t> stale_sites(const CcvtCells& cells);
  struct Names {
    std::uint32_t i, j;
  };
  /// How far a circle may move and grow before its pairs are found anew.
  float slack_of(const Circle& circle) const { return std::min(slack_, 0.5f * circle.radius); }
  std::vector<Names> find_uneven(const std::vector<std::uint32_t>& stale,
                                 const std::vector<std::uint8_t>& is_stale) const;
  std::vector<Names> find(const std::vector<std::uint32_t>& stale) const;
  void share_out(const std::vector<Names>& found);
  void list_by_site();

  bool keeps_account_;
  std::uint32_t block_;  ///< sites a block
  float slack_ = 0;      ///< of circles that are as large as even sites' ones
  std::vector<Circle> circles_;
  std::vector<Pair> pairs_;
  std::vector<std::size_t> tasks_;      ///< first pair of each task, by phase
  std::vector<std::size_t> phases_;     ///< first task of each phase
  std::vector<std::uint32_t> first_;    ///< of each site in of_site_
  std::vector<std::uint32_t> of_site_;  ///< the pairs of each site
};

}  // namespace capcon
