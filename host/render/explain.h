#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "render/device_context.h"
#include "scene/job.h"
#include "scene/scene.h"

namespace capcon {

/// One thing that a scene or the program has, and whether the job uses it.
struct FeatureRow {
  std::string name;      ///< "normals", "textures", ...
  std::string in_scene;  ///< what there is, in words
  bool used = false;
  std::string left_out;  ///< where not used: what was not done for it
};

/// A job with only what it needs, beside the same with everything kept.
struct Cost {
  double read_seconds = 0, build_seconds = 0, upload_seconds = 0;
  double compile_seconds = 0;      ///< of its kernels, with an empty driver cache
  double device_seconds = 0;       ///< median over the repeats
  std::uint64_t scene_bytes = 0;   ///< of meshes and images in memory
  std::uint64_t device_bytes = 0;  ///< of buffers
};

struct Explanation {
  std::vector<FeatureRow> rows;
  Cost needed, everything;
  double device_ratio = 1, device_ratio_low = 1,
         device_ratio_high = 1;  ///< needed / everything: median and range of repeats
  int repeats = 0;
  bool identical = false;  ///< the images, bit by bit
};

/// Renders the scene both ways, interleaved, `repeats` times, and compares. The film is the scene's unless
/// width and height are above 0.
Explanation explain(const std::string& scene_path, int width, int height, const Job& job,
                    const RendererOptions& options, int repeats = 5);

nlohmann::ordered_json to_json(const Explanation& explanation);
/// A table for people.
std::string to_text(const Explanation& explanation);

}  // namespace capcon
