#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "integrate/estimator.h"
#include "integrate/integrand.h"

namespace capcon::integrate {

struct Settings {
  std::vector<std::string> integrands;  ///< names; empty: all
  std::vector<std::string> estimators;  ///< names, "file:PATH" for a file of points; empty: all
  std::map<std::string, std::string> point_files = {};  ///< of an Experiment: see find_estimator
  std::vector<std::uint32_t> counts = {4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096};
  std::uint32_t randomisations = 1000;  ///< trials per integrand, estimator and count up to kFullCount points
  std::uint64_t seed = 1;
  bool quiet = false;  ///< no progress bar
};

/// Above so many points there are fewer trials, in proportion: a default run stays below a minute.
inline constexpr std::uint32_t kFullCount = 1024;
std::uint32_t trials_at(const Settings& settings, std::uint32_t n);

/// The text's bound beside the measured errors of one integrand, estimator and count.
struct Bound {
  enum class Kind : std::uint8_t {
    none,
    three_sigma,       ///< 3 sigma / sqrt(n): holds with probability 0.997
    koksma_hlawka,     ///< V(f) D*
    second_derivative  ///< hessian E / 2 + gradient F, see cell_sums.h
  };
  Kind kind = Kind::none;
  std::string missing;  ///< why there is none
  double mean = 0;  ///< over the trials that were checked; each has its own points, and its own f in a family
  double energy_part = 0;     ///< of a second-derivative bound: its first term
  std::uint32_t checked = 0;  ///< trials
  std::uint32_t exceeded = 0;
};

/// All trials of one integrand, estimator and count.
struct Sample {
  std::vector<double>
      errors;  ///< estimate - integral, a trial each; empty where the estimator does not apply
  Bound bound;
};

/// Processor seconds of the parts of one estimate.
struct Cost {
  double preparation = 0;  ///< what all randomisations share: a base set, a tile set
  double points = 0;       ///< one randomised set
  double weights = 0;
  double evaluation = 0;
};

struct Experiment {
  Settings settings;  ///< with no list empty
  std::vector<Sample> samples;
  std::vector<Cost> costs;
  double seconds = 0;  ///< on the clock, in all

  std::size_t index(std::size_t integrand, std::size_t estimator, std::size_t count) const {
    return (integrand * settings.estimators.size() + estimator) * settings.counts.size() + count;
  }
};

/// Runs all trials. Trial t has the same integrands for every estimator and count, so that ratios of errors
/// are those on the same integrals. Errors and bounds depend on the settings alone, not on the threads; the
/// costs are measured. InputError for unknown names or fewer than 2 randomisations.
Experiment run_experiment(Settings settings);

}  // namespace capcon::integrate
