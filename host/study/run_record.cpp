#include "study/run_record.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <limits>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/file.h"
#include "study/json_numbers.h"

namespace capcon {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// JSON has no infinity: a number, or null for what is not finite.
double number(const json& line, const char* name) {
  const json& value = line.at(name);
  const double v = value.get<double>();
  if (!std::isfinite(v) || v < 0) throw std::out_of_range(fmt::format("\"{}\" is not a size", name));
  return v;
}

/// What later readers of the header take for granted.
void check_header(const json& header) {
  if (header.at("settings_hash").get<std::string>().empty()) throw std::out_of_range("no hash");
  if (header.contains("started") && !header["started"].is_string()) throw std::out_of_range("no date");
}

RunRecord record_from(const json& line) {
  RunRecord r;
  r.run = {line.at("sampler").get<std::string>(), whole<std::uint32_t>(line, "samples", 1),
           whole<std::uint32_t>(line, "seed")};
  if (r.run.sampler.empty()) throw std::out_of_range("no sampler");
  r.mse = number(line, "mse");
  r.mse_trimmed = number(line, "mse_trimmed");
  r.relmse = number(line, "relmse");
  if (line.contains("flip")) r.flip = number(line, "flip");
  if (line.contains("mse_coarse")) r.mse_coarse = number(line, "mse_coarse");
  r.rays = whole<std::uint64_t>(line, "rays");
  r.device_seconds = number(line, "device_seconds");
  r.wall_seconds = number(line, "wall_seconds");
  r.point_generation_seconds = number(line, "point_generation_seconds");
  r.timings.wall = line.at("timings").at("wall").get<std::map<std::string, double>>();
  r.timings.device = line.at("timings").at("device").get<std::map<std::string, double>>();
  r.device = line.at("device").get<std::string>();
  if (line.contains("process")) {
    r.process = line.at("process").get<std::string>();
    r.calibration_seconds = number(line, "calibration_seconds");
  }
  return r;
}

}  // namespace

json parse_study_json(std::string_view text) {
  constexpr int kDeepest = 32;
  return json::parse(text, [](int depth, json::parse_event_t, const json&) {
    if (depth > kDeepest) throw std::out_of_range("too deep");
    return true;
  });
}

json to_json(const RunRecord& r) {
  json line = {{"sampler", r.run.sampler},
               {"samples", r.run.samples},
               {"seed", r.run.seed},
               {"mse", r.mse},
               {"mse_trimmed", r.mse_trimmed},
               {"relmse", r.relmse},
               {"mse_coarse", r.mse_coarse},
               {"rays", r.rays},
               {"device_seconds", r.device_seconds},
               {"wall_seconds", r.wall_seconds},
               {"point_generation_seconds", r.point_generation_seconds},
               {"timings", {{"wall", r.timings.wall}, {"device", r.timings.device}}},
               {"device", r.device}};
  if (r.flip >= 0) line["flip"] = r.flip;
  if (!r.process.empty()) {
    line["process"] = r.process;
    line["calibration_seconds"] = r.calibration_seconds;
  }
  return line;
}

RunFile read_runs(const fs::path& path) {
  const std::string bytes = read_file(path);
  RunFile file;
  int number_of_line = 0;
  for (std::size_t begin = 0; begin < bytes.size();) {
    const std::size_t end = bytes.find('\n', begin);
    if (end == std::string::npos) break;
    ++number_of_line;
    const SourcePlace place{path.string(), number_of_line, 0};
    try {
      const json line = parse_study_json(std::string_view(bytes).substr(begin, end - begin));
      if (number_of_line == 1) {
        check_header(line);
        file.header = line;
      } else {
        file.records.push_back(record_from(line));
      }
    } catch (const std::exception&) {
      throw InputError(place,
                       number_of_line == 1
                           ? "this is not the header of a study's runs; choose another folder with -o"
                           : "this is not a line of a study's runs; remove it, or start anew with --fresh");
    }
    begin = end + 1;
    file.complete_bytes = begin;
  }
  return file;
}

RunLog::RunLog(fs::path path, const json& header, bool fresh) : path_(std::move(path)), header_(header) {
  std::error_code error;
  if (fs::exists(path_, error)) {
    RunFile old;
    if (!fresh) old = read_runs(path_);
    if (old.complete_bytes > 0 && old.header["settings_hash"] == header.at("settings_hash")) {
      header_ = std::move(old.header);
      records_ = std::move(old.records);
      open(old.complete_bytes);
      return;
    }
    for (int i = 1; moved_.empty() || fs::exists(moved_, error); ++i) {
      moved_ = path_.parent_path() / fmt::format("runs.{}.jsonl", i);
    }
    fs::rename(path_, moved_, error);
    if (error) throw Failure(fmt::format("cannot move {}: {}", path_.string(), reason_of(error.value())));
  }
  const std::string first = header_.dump() + '\n';
  write_file(path_, first);  // whole, or there is no log: a log always has its header
  open(first.size());
}

void RunLog::open(std::uintmax_t bytes) {
  file_ = Descriptor(path_, O_RDWR);
  if (file_.get() < 0) fail_to_write(path_);
  bytes_ = bytes;
  cut();
}

/// Drops what follows the last whole line.
void RunLog::cut() {
  const auto end = static_cast<off_t>(bytes_);
  if (::ftruncate(file_.get(), end) != 0 || ::lseek(file_.get(), end, SEEK_SET) != end) fail_to_write(path_);
}

void RunLog::write_line(const std::string& line) {
  if (!is_still(file_.get(), path_)) {
    throw Failure(fmt::format(
        "{}: was removed or replaced while the study ran; nothing more is measured, start it again",
        path_.string()));
  }
  const std::string whole = line + '\n';
  if (!write_all(file_.get(), whole) || ::fdatasync(file_.get()) != 0) {
    const int reason = errno;
    if (::ftruncate(file_.get(), static_cast<off_t>(bytes_)) != 0) {
      // The next start drops what is no whole line.
    }
    errno = reason;
    fail_to_write(path_);
  }
  bytes_ += whole.size();
}

void RunLog::append(const RunRecord& record) {
  write_line(to_json(record).dump());
  records_.push_back(record);
}

const RunRecord* RunLog::find(const PlannedRun& run) const {
  const auto found =
      std::find_if(records_.begin(), records_.end(), [&](const RunRecord& r) { return r.run == run; });
  return found == records_.end() ? nullptr : &*found;
}

}  // namespace capcon
