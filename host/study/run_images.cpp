#include "study/run_images.h"

#include <fmt/format.h>

#include "base/error.h"
#include "base/file.h"

namespace capcon {
namespace fs = std::filesystem;

RunImages::RunImages(fs::path folder, std::string hash) : folder_(std::move(folder)), hash_(std::move(hash)) {
  create_folder(folder_);
}

fs::path RunImages::path(const PlannedRun& run) const {
  return folder_ / fmt::format("{}-{}-{}.exr", run.sampler, run.samples, run.seed);
}

void RunImages::write(const PlannedRun& run, const Image& image) const {
  write_exr(path(run), image,
            {{"sampler", run.sampler}, {"seed", static_cast<int>(run.seed)}, {"settingsHash", hash_}});
}

std::optional<Image> RunImages::read(const PlannedRun& run) const {
  std::error_code ignored;
  if (!fs::exists(path(run), ignored)) return std::nullopt;
  try {
    Attributes attributes;
    Image image = read_exr(path(run), &attributes);
    const auto found = attributes.find("settingsHash");
    if (found == attributes.end()) return std::nullopt;
    const auto* hash = std::get_if<std::string>(&found->second);
    if (!hash || *hash != hash_) return std::nullopt;
    return image;
  } catch (const InputError&) {
    return std::nullopt;  // broken, or not of a study: it is rendered again
  }
}

}  // namespace capcon
