#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/runner.h"

namespace capcon {

struct Region {
  int x = 0, y = 0, width = 0, height = 0;
};

/// One sampler at one number of samples, seen through the common region.
struct CloseUp {
  std::string sampler;
  std::uint32_t samples = 0;
  Image crop;
  Image difference;  ///< |crop - reference|
  double mse = 0;    ///< inside the region
  double flip = 0;   ///< the same, flip()
};

struct CloseUps {
  Image picture;  ///< the whole reference picture, larger than the study's images
  std::uint32_t picture_samples = 0;
  std::uint32_t seed = 1;
  Region region;
  Image reference;     ///< the region of `picture`
  float exposure = 1;  ///< of all differences: the hundredth largest of them becomes white
  std::vector<std::uint32_t> samples;
  std::vector<CloseUp> views;  ///< samples outermost, then samplers
};

/// The window of a map of errors that holds most of them.
Region worst_region(const Image& errors, int width, int height);
Image crop(const Image& image, const Region& region);
/// |a - b| of images of one shape.
Image absolute_difference(const Image& a, const Image& b);

/// Renders the scene larger, with every sampler at 4 and 16 samples (splitting: at the middle one of its
/// splits; global illumination: at 4 sets), and cuts out the region where all samplers together err most at
/// the last of these: nobody's choice, and where a difference shows first.
CloseUps make_close_ups(const StudySettings& settings, const MakeStudyDevice& make_device,
                        const RunnerOptions& options);

/// Beside a study's other files.
inline constexpr const char* kCloseUpFolder = "close-ups";

/// Keeps them in `folder` (it is created), so that the report can be made again without a device: the picture
/// and the crops as EXR, what they are in close-ups.json. `hash`: of the settings they were made with.
void write_close_ups(const std::filesystem::path& folder, const CloseUps& close_ups, const std::string& hash);
/// The same, if they are there, whole and of these settings; else nothing.
std::optional<CloseUps> read_close_ups(const std::filesystem::path& folder, const std::string& hash);

}  // namespace capcon
