#pragma once

#include <string>

#include "reference/reference.h"
#include "render/renderer.h"
#include "scene/job.h"
#include "scene/scene.h"

namespace capcon::cli {

/// Whether the file is a picture, which needs an image of the scene below its dots; else it is a list.
bool is_light_picture(const std::string& path);
/// `capcon render --show-virtual-lights FILE`: InputError unless the job has VPLs and the name ends in .png,
/// .csv or .json.
void check_light_file(const std::string& path, const Job& job);

/// Writes the job's VPLs: a picture over `image`, which the job rendered, or a list.
void write_lights(const std::string& path, const Scene& scene, const GlobalIlluminationJob& job,
                  const Image& image, Renderer& renderer);
void write_lights(const std::string& path, const Scene& scene, const GlobalIlluminationJob& job,
                  const Image& image, const Reference& reference);

}  // namespace capcon::cli
