#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "study/clocks.h"
#include "study/figures.h"

namespace capcon {

/// One sampler at one number of samples: a value for every seed.
struct Column {
  std::uint32_t samples = 0;
  std::vector<double> mse;                                   ///< the reference's own error taken off
  std::vector<double> device, wall, without_points, points;  ///< seconds, of one clock
  std::vector<double> relmse, flip;                          ///< empty where a run has none
  bool sure = false;
};

namespace columns {

using Kept = std::span<const std::size_t>;  ///< indices of seeds

/// By rising samples. An MSE estimate can fall to zero or below when the reference's error is taken off: then
/// there is no logarithm, and the column is not sure anyway.
std::vector<Column> of(const StudyResult& result, const Clocks& clocks, const std::string& sampler);

/// The same with the first `seeds` seeds alone.
std::vector<Column> first_seeds(std::vector<Column> all, std::size_t seeds);

double geometric_mean_of(const std::vector<double>& values, Kept kept);

/// The sure part of a curve for some of the seeds.
struct Path {
  std::vector<double> samples, device, mse;
};
Path path(const std::vector<Column>& columns, Kept kept, std::uint32_t from = 1);

/// A sampler beside `baseline[at]`; both have the same seeds, or as many independent ones. Sampler and
/// baseline are left to the caller.
Ratio ratio(const std::vector<Column>& columns, const std::vector<Column>& baseline, std::size_t at);

}  // namespace columns
}  // namespace capcon
