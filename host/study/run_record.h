#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/descriptor.h"
#include "study/plan.h"

namespace capcon {

/// One finished measurement: a line of runs.jsonl. Errors are against the reference image as it is; its own
/// error is taken off later. Seconds.
struct RunRecord {
  PlannedRun run;
  double mse = 0;
  double mse_trimmed = 0;
  double relmse = 0;
  double flip = -1;       ///< flip(); below 0 in files from before it was measured
  double mse_coarse = 0;  ///< coarse_mse(); 0 in files from before it was measured
  std::uint64_t rays = 0;
  double device_seconds =
      0;                    ///< sum of the device's own timings; without any: wall time without making points
  double wall_seconds = 0;  ///< the whole render call, without compiling kernels
  double point_generation_seconds = 0;  ///< the part of wall_seconds that made the points
  Timings timings;
  std::string device;
  /// Of a study by several processes, the one that measured it: "2/4 on HOST". Empty: there was one.
  std::string process;
  /// What calibration_seconds() found in that process: what its times are worth beside another's. 0: one.
  double calibration_seconds = 0;
};

nlohmann::json to_json(const RunRecord& record);

/// What a runs.jsonl holds: a header line, then one line a run. An unfinished last line (a killed study) is
/// left out.
struct RunFile {
  nlohmann::json header;
  std::vector<RunRecord> records;
  std::uintmax_t complete_bytes = 0;  ///< length of the file without an unfinished last line
};

/// Throws for what is no JSON, or nests deeper than anything a study writes: copies would go as deep on the
/// stack.
nlohmann::json parse_study_json(std::string_view text);

/// InputError with file:line for a line that is not what it should be.
RunFile read_runs(const std::filesystem::path& path);

/// runs.jsonl as a study goes: opened once, every line flushed to disk, so that what is finished stays
/// whatever happens.
class RunLog {
 public:
  /// Goes on with `path` if its header has the same "settings_hash"; else, or when `fresh`, the file is kept
  /// beside under another name and a new one starts with `header`. Failure when it cannot be written.
  RunLog(std::filesystem::path path, const nlohmann::json& header, bool fresh);

  void append(const RunRecord& record);
  const std::vector<RunRecord>& records() const { return records_; }
  const nlohmann::json& header() const { return header_; }
  /// The finished run of this kind, or nullptr.
  const RunRecord* find(const PlannedRun& run) const;
  /// Where an older file with other settings went; empty when there was none.
  const std::filesystem::path& moved() const { return moved_; }

 private:
  void open(std::uintmax_t bytes);
  void cut();
  void write_line(const std::string& line);

  std::filesystem::path path_;
  std::filesystem::path moved_;
  nlohmann::json header_;
  std::vector<RunRecord> records_;
  Descriptor file_;
  std::uintmax_t bytes_ = 0;  ///< of whole lines
};

}  // namespace capcon
