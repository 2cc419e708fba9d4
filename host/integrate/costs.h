#pragma once

#include <array>
#include <optional>

#include "integrate/experiment.h"

namespace capcon::integrate {

/// Measures what one estimate with points of a source costs. One thread; each part is repeated for some
/// tenths of a millisecond.
class CostMeter {
 public:
  explicit CostMeter(const PointSource& source);
  Cost cost(const Integrand& integrand, const Draw& draw, Weights weights);

 private:
  const PointSource& source_;
  Points points_;
  double seconds_ = 0;                               ///< of one set
  std::array<std::optional<double>, 2> cell_costs_;  ///< in the square, on the torus
};

}  // namespace capcon::integrate
