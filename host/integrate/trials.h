#pragma once

#include <span>

#include "integrate/cell_sums.h"
#include "integrate/estimator.h"
#include "integrate/integrand.h"

namespace capcon::integrate {

/// One randomised set with what the integrands of one trial ask of it; each part is made when first asked
/// for.
class TrialPoints {
 public:
  TrialPoints(const PointSource& source, std::uint64_t trial)
      : TrialPoints(source, trial, source.set(trial)) {}
  /// With the source's set already at hand.
  TrialPoints(const PointSource& source, std::uint64_t trial, Points set)
      : source_(source), trial_(trial), points_(std::move(set)) {}

  /// The estimate of an integrand's integral.
  double estimate(const Integrand& integrand, const Draw& draw, Weights weights);

  const Points& points() const { return points_; }
  const CellSums& cells(Domain domain);  ///< on the torus, or in the square
  double discrepancy();                  ///< star discrepancy

 private:
  const Points& on_disk();

  const PointSource& source_;
  std::uint64_t trial_;
  Points points_, disk_;
  std::optional<TorusCells> cells_;
  std::optional<CellSums> torus_, square_;
  std::optional<double> discrepancy_;
};

}  // namespace capcon::integrate
