#include "stability/check.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace capcon::stability {

nlohmann::ordered_json to_json(const std::vector<Check>& checks) {
  auto rows = nlohmann::ordered_json::array();
  for (const Check& c : checks) {
    nlohmann::ordered_json row = {
        {"group", c.group},           {"name", c.name},     {"what", c.what},     {"values", c.values},
        {"non_finite", c.non_finite}, {"largest", nullptr}, {"beyond", c.beyond}, {"measured", c.measured},
        {"bound", c.bound},           {"reason", c.reason}, {"passed", c.passed}, {"seconds", c.seconds},
        {"command", c.command}};
    if (std::isfinite(c.largest)) row["largest"] = c.largest;
    if (!c.device.empty()) row["device"] = c.device;
    if (!c.curve.empty()) row["curve"] = c.curve;
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string to_text(const std::vector<Check>& checks) {
  std::string text, group;
  std::size_t passed = 0;
  double seconds = 0;
  for (const Check& c : checks) {
    if (c.group != group) {
      group = c.group;
      text += fmt::format("\n{}\n{:<26} {:>10} {:>7} {:>9} {:>7} {:>7}  {}\n", group, "", "values", "NaN/inf",
                          "largest", "beyond", "s", "verdict");
    }
    const std::string largest = std::isfinite(c.largest) ? fmt::format("{:.1e}", c.largest) : "";
    text += fmt::format("{:<26} {:>10} {:>7} {:>9} {:>7} {:>7.1f}  {} {}\n", c.name, c.values, c.non_finite,
                        largest, c.beyond, c.seconds, c.passed ? "ok    " : "FAILED", c.measured);
    if (!c.passed)
      text += fmt::format("{:<26} wanted: {} ({})\n{:<26} {}\n", "", c.bound, c.reason, "", c.command);
    passed += c.passed;
    seconds += c.seconds;
  }
  text += fmt::format("\n{} of {} checks passed in {:.0f} s\n", passed, checks.size(), seconds);
  return text;
}

}  // namespace capcon::stability
