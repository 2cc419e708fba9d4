#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "scene/job.h"

namespace capcon::serve {

/// A scene that the page offers: what it is called there, and its file.
struct OfferedScene {
  std::string name, file;
};

/// What one comparison is about; a plain value.
struct Settings {
  OfferedScene scene;
  std::string integrator = "ao";  ///< ao, direct or igi
  std::vector<std::string> samplers;
  std::string device = "best";
  double radius = 0;            ///< of ambient occlusion; 0: by the scene's size
  std::uint32_t split = 1;      ///< direct: P image samples a pixel, a power of two
  int width = 240, height = 0;  ///< height 0: by the film's shape
  bool equal_time = true;       ///< the samplers get the same device time, else the same samples
  double frame_seconds = 2;     ///< the frame time that is asked about
};

/// Checked: InputError, one sentence, for anything that is missing, unknown, of the wrong kind or out of
/// range. `scenes`: the only ones that can be named.
Settings parse_settings(const nlohmann::json& json, const std::vector<OfferedScene>& scenes);

/// One frame: `count` points a pixel; of igi sets of light paths.
Job make_job(const Settings& settings, const std::string& sampler, std::uint32_t count, std::uint32_t seed);
/// The command line that makes the same bits (width and height as they were rendered).
std::string command_of(const Settings& settings, const std::string& sampler, std::uint32_t count,
                       std::uint32_t seed, int width, int height);
/// Largest count that is tried; the least is that of `first_count`.
std::uint32_t largest_count(const Settings& settings, const std::string& sampler);
inline std::uint32_t first_count(const Settings& settings) {
  return settings.integrator == "direct" ? settings.split : 1;
}

}  // namespace capcon::serve
