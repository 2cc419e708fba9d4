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
/// How much longer `other` takes than `curve` for the relMSE that this has in `seconds`. Both independent:
/// squares of half widths of logarithms add up. NaN as above.
Interval time_ratio(const Curve& curve, const Curve& other, double seconds);

/// Which sampler to use in `seconds` a frame: "headline" in a few words, "text" with figures. "decided" only
/// where its interval of time ratios to each other sampler excludes 1.
nlohmann::ordered_json answer(const std::vector<Curve>& curves, double seconds, const std::string& device);

}  // namespace capcon::serve
