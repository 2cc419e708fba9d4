#pragma once

#include <vector>

#include "points/ccvt_cells.h"

namespace capcon {

/// Lets sites run ahead of their centroids, before each pass by so many times the way that these came in the
/// last one (momentum, Nesterov 1983): fewer passes bring them to their ends. And by more than one time the
/// way they get past places where no exchange gains but for the space points' coarseness. Exchanges then no
/// longer lower the energy one by one, so it is for coarse capacities, which are but a start for the next.
class CcvtLeads {
 public:
  /// `factor` 0: none.
  explicit CcvtLeads(double factor) : factor_(factor) {}
  /// Before a pass.
  void renew(CcvtCells& cells);
  /// Puts the sites at their centroids again.
  void end(CcvtCells& cells) const;

 private:
  void set(CcvtCells& cells, std::size_t i, double x, double y) const;

  double factor_;
  std::vector<TorusPoint> before_;  ///< the centroids before the last pass
};

}  // namespace capcon
