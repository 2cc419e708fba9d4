#pragma once

#include <map>
#include <string>
#include <vector>

#include "render/device_context.h"
#include "scene/job.h"
#include "scene/scene.h"
#include "stability/check.h"

namespace capcon::stability {

/// How near the device's image must be to the reference's.
struct ImageBound {
  /// A pixel deviates by the largest difference of a channel, relative to the reference there or to the mean
  /// of its image, whichever is larger.
  double tolerance = 1e-4;
  double share = 0.01;  ///< of pixels that may be beyond it: rays that pass an edge on the other side
  double bias = 1e-3;   ///< of the difference of the means, relative to the reference's
  std::string reason;
};

/// A scene that is hard for floats, rendered on the device and in double on the reference with the same
/// points.
struct ImageCase {
  std::string group, name, what;
  std::string scene;  ///< pbrt text, with its film
  Job job;
  ImageBound bound = {};
  std::map<std::string, std::string> files = {};  ///< what it names: name -> bytes
  std::map<std::string, Image> images = {};       ///< likewise, written as EXR
};

/// Where cases run.
struct Workshop {
  std::string device = "best";
  std::string folder;  ///< scenes and files are written here, each once
};

/// Where a case's scene lies.
std::string path_of(const ImageCase& c, const Workshop& workshop);
/// Writes it and what it names; its path.
std::string write_case(const ImageCase& c, const Workshop& workshop);
/// The scene that a case wrote, with what its job needs.
Scene read_case(const ImageCase& c, const Workshop& workshop);
RendererOptions renderer_options(const Job& job, const Workshop& workshop);
/// Renders both and compares.
Check run_case(const ImageCase& c, const Workshop& workshop);
/// `capcon render ...` for the job.
std::string command_of(const std::string& scene, const Job& job);

// Jobs of the suite: few samples, as the points are the same on both sides.
AmbientOcclusionJob occlusion(double radius);
DirectLightingJob direct();
GlobalIlluminationJob igi(Clamping clamping = Clamping::compensate);

}  // namespace capcon::stability
