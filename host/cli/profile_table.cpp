#include "cli/profile_table.h"

#include <fmt/format.h>

#include <array>

namespace capcon::cli {
namespace {

struct Stage {
  const char* name;
  const char* what;
};

// The order of the work; what another integrator does is left out; "trace" is the reference's, which does not
// tell its rays apart.
constexpr std::array<Stage, 18> kStages{{
    {"device", "open the device (while reading)"},
    {"read", "scene files"},
    {"shading", "materials and lights, their tables"},
    {"build", "tree"},
    {"compile", "kernels (while building)"},
    {"upload", "buffers"},
    {"points", "sample points on the host"},
    {"light paths", "where virtual lights lie"},
    {"primary", "what the pixels see"},
    {"occlusion", "occlusion rays"},
    {"emission", "lights that are seen"},
    {"light samples", "shading and shadow rays"},
    {"bsdf samples", "shading and BSDF rays"},
    {"gather", "rays to virtual lights"},
    {"compensation", "what clamping leaves out"},
    {"trace", "all rays"},
    {"resolve", "sums to an image"},
    {"write", "files"},
}};

std::string milliseconds(const std::map<std::string, double>& times, const std::string& stage) {
  const auto found = times.find(stage);
  return found == times.end() ? "-" : fmt::format("{:.1f}", 1e3 * found->second);
}

}  // namespace

std::string profile_table(const Timings& timings, double whole_seconds, double first_dispatch_seconds) {
  std::string text = fmt::format("{:14} {:>10} {:>10}\n", "stage", "wall ms", "device ms");
  for (const Stage& stage : kStages) {
    const bool ran = timings.wall.contains(stage.name) || timings.device.contains(stage.name);
    if (!ran && std::string(stage.name) == "trace") continue;
    text += fmt::format("{:14} {:>10} {:>10}  {}{}\n", stage.name, milliseconds(timings.wall, stage.name),
                        milliseconds(timings.device, stage.name), stage.what, ran ? "" : ": left out");
  }
  text += fmt::format("{:14} {:>10.1f}\n", "whole", 1e3 * whole_seconds);
  if (first_dispatch_seconds > 0) {
    text += fmt::format("The first rays were handed to the device after {:.1f} ms.\n",
                        1e3 * first_dispatch_seconds);
  }
  return text;
}

}  // namespace capcon::cli
