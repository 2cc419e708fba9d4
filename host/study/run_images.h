#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "image/image.h"
#include "study/plan.h"

namespace capcon {

/// The images of a study's runs, one EXR each in the study's folder: what is computed over seeds is then the
/// same whether the study was made at once, resumed or extended.
class RunImages {
 public:
  /// Images of other settings than those of `hash` (settings_hash()) count as missing. The folder is created:
  /// Failure where it cannot be.
  RunImages(std::filesystem::path folder, std::string hash);

  void write(const PlannedRun& run, const Image& image) const;
  /// Nothing where it is not there or not ours.
  std::optional<Image> read(const PlannedRun& run) const;

 private:
  std::filesystem::path path(const PlannedRun& run) const;

  std::filesystem::path folder_;
  std::string hash_;
};

}  // namespace capcon
