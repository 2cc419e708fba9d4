#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "image/image.h"
#include "study/plan.h"

namespace capcon {

/// Does a job: the device, the oracle, or a test's stand-in.
using RenderJob = std::function<RenderResult(const Job&)>;

/// A converged image that knows how far it is itself from the truth.
struct ReferenceImage {
  Image image;  ///< mean over independent groups
  double error =
      0;  ///< expected MSE of `image`: mean over pixels of the groups' sample variance, divided by groups
  double coarse_error = 0;  ///< the same of the means of blocks: its expected coarse_mse()
};

/// Mean and error estimate of at least two independent images of one size.
ReferenceImage combine_groups(const std::vector<Image>& groups);

/// reference.exr with its error and the settings' hash among its attributes.
void write_reference(const std::filesystem::path& path, const ReferenceImage& reference,
                     const StudySettings& settings, const std::string& hash);
/// The same, if the file is there and made with these settings; else nothing.
std::optional<ReferenceImage> read_reference(const std::filesystem::path& path, const std::string& hash);

}  // namespace capcon
