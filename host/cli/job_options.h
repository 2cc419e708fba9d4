#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "image/image.h"
#include "scene/job.h"

namespace capcon::cli {

/// The options that say what is estimated, of `capcon render`.
struct JobOptions {
  std::string integrator = "ao", sampler = "capcon", position = "centre", split, filter = "box",
              strategy = "power", screen = "none";
  double radius = std::numeric_limits<double>::infinity();
  std::uint32_t samples = 16, seed = 1;
  bool no_partition = false;
  std::string path_sampler, clamping = "compensate";  ///< igi; no sampler: that of the pixel
  std::uint32_t paths = 128, sets = 4, gather = 1, block = 1;
  double limit = 0;
  bool indirect = false, two_sided = false;

  void add_to(CLI::App& verb);
  /// Checked: InputError for what does not go together.
  Job job() const;
  /// All that makes the image what it is, in words: for the key of a partial image.
  std::string key() const;
  /// Rays of a kind a pixel.
  std::uint32_t samples_a_pixel() const;
  int channels() const { return integrator == "ao" ? 1 : 3; }

 private:
  void add_global_illumination(CLI::App& verb);
  void check() const;
  DirectLightingJob direct_job() const;
  GlobalIlluminationJob global_illumination_job() const;
};

/// As EXR attributes, and as fields of a report.
void describe(const JobOptions& options, Attributes& attributes);
void describe(const JobOptions& options, nlohmann::ordered_json& json);

/// "4x16" as image samples and integrator samples. InputError otherwise.
std::pair<std::uint32_t, std::uint32_t> parse_split(const std::string& text);

}  // namespace capcon::cli
