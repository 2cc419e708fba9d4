#pragma once

#include <cmath>

#include "base/statistics.h"
#include "integrate/experiment.h"

namespace capcon::integrate {

/// What the trials of one integrand, estimator and count say.
struct Figure {
  bool measured = false;
  bool exact = false;                     ///< the error is rounding alone
  Interval rmse{NAN, NAN, NAN};           ///< root of the mean squared error
  Interval beside_random{NAN, NAN, NAN};  ///< MSE / MSE of random points on the same integrals
  Interval beside_owen{NAN, NAN, NAN};    ///< MSE / MSE of sobol-owen
  double bias_z = 0;                      ///< mean error over its own standard error
};

/// One integrand, one estimator: the law of its RMSE.
struct Law {
  Interval slope;  ///< of log RMSE over log n, from kSlopeFrom points on; NaN for fewer than two such counts
                   ///< or where some error is rounding
};

inline constexpr std::uint32_t kSlopeFrom = 16;
/// An RMSE below this is rounding: all integrands are of size 1.
inline constexpr double kRounding = 1e-13;

struct Analysis {
  std::vector<Figure> figures;  ///< by Experiment::index
  std::vector<Law> laws;        ///< by integrand * estimators + estimator
};

/// Intervals are 95 %: the trials are cut into 20 groups (fewer for fewer trials); the RMSE's is Student's on
/// the groups' MSEs, ratios and slopes use the jackknife over groups. They speak of the randomisations of the
/// base sets at hand.
Analysis analyse(const Experiment& experiment);

/// MSE of one sample over that of another on the same integrals, with its interval. NaN where one is missing
/// or the second is rounding.
Interval mse_ratio(const Sample& sample, const Sample& baseline);

}  // namespace capcon::integrate
