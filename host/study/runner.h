#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "study/reference_image.h"
#include "study/run_images.h"
#include "study/run_record.h"

namespace capcon {

/// Something that renders the study's scene at one image size.
struct StudyDevice {
  RenderJob render;
  nlohmann::json info;  ///< name, driver, ... for the report
};
/// Makes one for a width and a height.
using MakeStudyDevice = std::function<StudyDevice(int width, int height)>;

struct RunnerOptions {
  std::filesystem::path directory;
  bool fresh = false;  ///< measure again what is already there
  bool quiet = false;
  /// Of a process of several: others work on the same device meanwhile, so that no time of it can be
  /// compared.
  bool shares_device = false;
};

/// All that was measured.
struct StudyResult {
  StudySettings settings;
  nlohmann::json device;
  std::string started;  ///< UTC, of the first measurement: "2026-01-31 12:34"
  std::string version;
  ReferenceImage reference;
  std::vector<RunRecord> records;  ///< in the plan's order
  std::size_t resumed = 0;         ///< how many of them were there before
  std::filesystem::path moved;     ///< where older runs with other settings were put, if there were any
};

/// The images of a study's runs, kept where keeps_images().
RunImages run_images(const std::filesystem::path& directory, const std::string& hash);

/// Makes reference.exr and runs.jsonl in options.directory (it is created), or goes on with those that are
/// there. What was measured is on disk before the next render starts, so that the result is the same wherever
/// the process was ended (by a signal, kill -9, a full disk) and started again; times aside.
StudyResult run_study(const StudySettings& settings, const StudyDevice& device, const RunnerOptions& options);

}  // namespace capcon
