#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "base/statistics.h"
#include "serve/comparison.h"

namespace capcon::serve {

/// A sampler's curve: cells by rising count.
struct Curve {
  std::string sampler;
  const std::vector<Cell>* cells;
};

/// Of a cell's frames; NaN where there are none.
double mean_seconds(const Cell& cell);
/// The first cell that says something of `seconds` a frame: the longest that takes no longer, else the first.
std::size_t first_needed(const std::vector<Cell>& cells, double seconds);

/// What a sampler's error is in `seconds` a frame: read off its curve (straight in log-log) of mean relMSE
/// over mean device time, with the jackknife over seeds that both cells around that time have; the others
/// count with what they have. NaN where the curve does not reach there, or with NaN ends where there are
/// fewer than two such seeds.
Interval relmse_at(const Curve& curve, double seconds);
/// How many times `other` errs as much in `seconds` as `curve` does: the jackknife over seeds of both
/// together.
Interval error_ratio(const Curve& curve, const Curve& other, double seconds);
/// How much longer `other` takes for the relMSE that `curve` has in `seconds`, likewise. NaN where it was not
/// measured for that long.
Interval time_ratio(const Curve& curve, const Curve& other, double seconds);

/// Which sampler to use in `seconds` a frame: "headline" in a few words, "text" with figures. "decided" only
/// where the intervals of all other samplers' error ratios lie above 1.
nlohmann::ordered_json answer(const std::vector<Curve>& curves, double seconds, const std::string& device);

}  // namespace capcon::serve
