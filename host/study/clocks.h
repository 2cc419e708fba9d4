#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "study/runner.h"

namespace capcon {

/// Whose clocks measured a study: one process's, or several, each with a calibration of its own.
struct Clock {
  std::string process;  ///< "2/4 on HOST"; empty: a process that was alone
  std::string device;
  std::size_t runs = 0;
  double calibration_seconds = 0;  ///< of one and the same job; 0: not known
  double factor = 1;               ///< what this clock's seconds are multiplied by: those of the first
};

/// Times of several clocks are not mixed as they are: each is multiplied by the first clock's calibration
/// over its own, which is right where one machine is so many times as fast as another at everything. Between
/// unlike devices, or without a calibration (side by side on one device), it is not so: nothing is compared
/// in equal time.
class Clocks {
 public:
  explicit Clocks(const StudyResult& result);

  const std::vector<Clock>& all() const { return all_; }
  bool several() const { return all_.size() > 1; }
  /// Whether all are of one kind of device, and calibrated.
  bool comparable() const { return comparable_; }
  double factor(const RunRecord& record) const;
  /// For people: how many, and what was done about it; empty where there is one.
  std::string sentence() const;

 private:
  std::vector<Clock> all_;
  bool comparable_ = true;
};

/// For study.json.
nlohmann::json to_json(const Clocks& clocks);

}  // namespace capcon
