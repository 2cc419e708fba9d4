#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "points/kd_tree.h"
#include "points/lattice.h"

namespace capcon {

/// A circle on the torus, lengths in units of 2^-32 of it.
struct CcvtCircle {
  TorusPoint centre{0, 0};
  float radius = -1;  ///< negative: not known yet
};

/// Circles of very different sizes and density, in a tree of boxes: which of them overlap.
class CcvtCircleTree {
 public:
  /// Each circle's radius is taken larger by its slack. `seeks`: those which `overlaps` is going to be called
  /// for.
  CcvtCircleTree(const std::vector<CcvtCircle>& circles, const std::vector<float>& slacks,
                 const std::vector<std::uint8_t>& seeks);

  /// Calls found(j) for the circles that overlap circle i, but for those which do the seeking themselves and
  /// are larger, or as large and later: so each pair is found once.
  void overlaps(std::uint32_t i, const std::function<void(std::uint32_t)>& found) const;

 private:
  float reach(std::uint32_t i) const { return circles_[i].radius + slacks_[i]; }

  const std::vector<CcvtCircle>& circles_;
  const std::vector<float>& slacks_;
  const std::vector<std::uint8_t>& seeks_;
  KdTree tree_;
  std::vector<float> seeking_, waiting_;  ///< of each node: largest reach of those which seek, and of others
};

}  // namespace capcon
