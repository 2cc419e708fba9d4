#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/statistics.h"
#include "study/noise.h"
#include "study/recommendation.h"
#include "study/runner.h"

namespace capcon {

/// What the seeds of one sampler at one number of samples say. Geometric means over the seeds.
struct Cell {
  std::uint32_t samples = 0;
  Interval mse;         ///< after the reference's own error is taken off
  Interval relmse;      ///< geometric mean; the reference's own error is not taken off
  Interval flip;        ///< FLIP at exposure 1, arithmetic mean; NaN where it was not measured
  double mean_mse = 0;  ///< the arithmetic mean, for those who compare with other programs
  Interval device_seconds;
  Interval wall_seconds;  ///< with the points' generation
  Interval wall_without_points;
  double point_seconds = 0;  ///< arithmetic mean
  bool sure = false;         ///< mse is at least kReferenceMargin times the reference's error
};

/// A sampler's cells, by rising samples.
struct Curve {
  std::string sampler;
  std::vector<Cell> cells;
  Interval slope;       ///< of log MSE over log samples, sure cells with at least kSlopeFrom samples
  Interval time_slope;  ///< of log MSE over log device seconds, the same cells
  std::uint32_t slope_cells = 0;
};

/// One comparison of a sampler with a baseline at the baseline's number of samples.
struct Ratio {
  std::string sampler;
  std::string baseline;
  std::uint32_t samples = 0;
  Interval mse;          ///< MSE / baseline's MSE at equal samples
  Interval equal_error;  ///< samples the sampler needs for the baseline's MSE; NaN if out of its range, see
                         ///< `beyond`
  int beyond = 0;        ///< -1: fewer than the fewest samples measured, +1: more than the most
  Interval equal_error_time;  ///< device time of these samples / baseline's device time
  Interval equal_time;  ///< MSE / baseline's MSE at the baseline's device seconds; NaN if the sampler was
                        ///< never so short or long
};

inline constexpr double kReferenceMargin = 3;
inline constexpr std::uint32_t kSlopeFrom = 4;

struct Figures {
  std::vector<Curve> curves;
  std::vector<Ratio> ratios;
  std::vector<std::string> baselines;  ///< those of sobol-xor and sobol-owen that were measured
  double reference_error = 0;
  std::string clocks;  ///< Clocks::sentence()
  std::optional<Recommendation> recommendation;
  Noise noise;  ///< of studies that keep the images of their runs

  const Curve* curve(const std::string& sampler) const;
  const Ratio* ratio(const std::string& sampler, const std::string& baseline, std::uint32_t samples) const;
};

const Cell* find_cell(const Curve& curve, std::uint32_t samples);

/// All figures of a study. Intervals are 95 %, over seeds, by the jackknife on logarithms.
Figures make_figures(const StudyResult& result);

/// study.json: settings, device, reference and every figure.
nlohmann::json to_json(const StudyResult& result, const Figures& figures);

}  // namespace capcon
