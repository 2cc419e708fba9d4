#pragma once

#include <cstdint>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

namespace capcon::stability {

/// One row of the suite: what was done, what was measured, and the bound that it was held against.
struct Check {
  std::string group;             ///< "scale and place", "geometry", ...
  std::string name;              ///< unique in the suite, as in `--only`
  std::string what;              ///< a phrase: what is extreme here
  std::uint64_t values = 0;      ///< pixels, rays or sets that were looked at
  std::uint64_t non_finite = 0;  ///< of them
  /// Largest relative deviation from the double-precision reference; NaN where something else is measured.
  double largest = std::numeric_limits<double>::quiet_NaN();
  std::uint64_t beyond = 0;  ///< values that deviate by more than the tolerance
  std::string measured;      ///< the figure in words, where the columns above do not say it all
  std::string bound;         ///< what had to hold
  std::string reason;        ///< why that bound
  std::vector<std::pair<double, double>> curve =
      {};  ///< (samples a pixel, RMSE), where error falls with samples
  bool passed = false;
  double seconds = 0;
  std::string device = {};  ///< the device's own name; empty where none was used
  std::string command;      ///< renders it again; empty where there is no single one
};

nlohmann::ordered_json to_json(const std::vector<Check>& checks);
/// A table for a terminal, one line a check, then what failed with its bound and reason.
std::string to_text(const std::vector<Check>& checks);

}  // namespace capcon::stability
