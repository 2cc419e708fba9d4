#include "study/clocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <tuple>

namespace capcon {
namespace {

/// A process that was stopped and went on calibrated again, maybe on another machine.
bool is_of(const Clock& clock, const RunRecord& record) {
  return clock.process == record.process && clock.device == record.device &&
         clock.calibration_seconds == record.calibration_seconds;
}

}  // namespace

Clocks::Clocks(const StudyResult& result) {
  for (const RunRecord& record : result.records) {
    auto clock = std::find_if(all_.begin(), all_.end(), [&](const Clock& c) { return is_of(c, record); });
    if (clock == all_.end())
      clock = all_.insert(all_.end(), {record.process, record.device, 0, record.calibration_seconds, 1});
    ++clock->runs;
  }
  std::sort(all_.begin(), all_.end(), [](const Clock& a, const Clock& b) {
    return std::tuple(a.process, a.device, a.calibration_seconds) <
           std::tuple(b.process, b.device, b.calibration_seconds);
  });
  if (!several()) return;
  for (Clock& clock : all_) {
    comparable_ = comparable_ && clock.calibration_seconds > 0 && clock.device == all_.front().device;
    if (clock.calibration_seconds > 0 && all_.front().calibration_seconds > 0)
      clock.factor = all_.front().calibration_seconds / clock.calibration_seconds;
  }
}

double Clocks::factor(const RunRecord& record) const {
  if (!several()) return 1;
  return std::find_if(all_.begin(), all_.end(), [&](const Clock& c) { return is_of(c, record); })->factor;
}

std::string Clocks::sentence() const {
  if (!several()) return {};
  if (!comparable_) {
    return fmt::format(
        "Times come from {} clocks, of unlike devices or of processes side by side on one: samplers are not "
        "compared "
        "in equal time.",
        all_.size());
  }
  double least = all_.front().factor, most = least;
  for (const Clock& clock : all_) {
    least = std::min(least, clock.factor);
    most = std::max(most, clock.factor);
  }
  return fmt::format(
      "Times come from {} clocks; each is multiplied by what one and the same job took on the first, over "
      "what it took "
      "there ({:.2f} to {:.2f}).",
      all_.size(), least, most);
}

nlohmann::json to_json(const Clocks& clocks) {
  nlohmann::json json = nlohmann::json::array();
  for (const Clock& clock : clocks.all()) {
    json.push_back({{"process", clock.process},
                    {"device", clock.device},
                    {"runs", clock.runs},
                    {"calibration_seconds", clock.calibration_seconds},
                    {"time_factor", clock.factor}});
  }
  return json;
}

}  // namespace capcon
