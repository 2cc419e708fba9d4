#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "image/compare.h"
#include "image/flip.h"
#include "study/close_up_facts.h"

namespace capcon {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

std::string file_of(const CloseUp& view) {
  return fmt::format("{}-{}.exr", view.sampler, view.samples);
}

Image read_of_size(const fs::path& path, int width, int height, int channels) {
  Image image = read_exr(path);
  if (image.width != width || image.height != height || image.channels != channels)
    throw InputError(path.string() + ": another size");
  return image;
}

}  // namespace

void write_close_ups(const fs::path& folder, const CloseUps& c, const std::string& hash) {
  create_folder(folder);
  write_exr(folder / "picture.exr", c.picture);
  json views = json::array();
  for (const CloseUp& view : c.views) {
    write_exr(folder / file_of(view), view.crop);
    views.push_back({{"sampler", view.sampler}, {"samples", view.samples}});
  }
  // Last, so that what it names is there.
  write_file(folder / "close-ups.json",
             json{{"settings_hash", hash},
                  {"picture_samples", c.picture_samples},
                  {"seed", c.seed},
                  {"region", {c.region.x, c.region.y, c.region.width, c.region.height}},
                  {"exposure", c.exposure},
                  {"samples", c.samples},
                  {"views", views}}
                     .dump(2) +
                 "\n");
}

std::optional<CloseUps> read_close_ups(const fs::path& folder, const std::string& hash) {
  std::error_code ignored;
  if (!fs::exists(folder / "close-ups.json", ignored)) return std::nullopt;
  try {
    CloseUpFacts facts = parse_close_up_facts(read_file(folder / "close-ups.json"));
    if (facts.hash != hash) return std::nullopt;
    CloseUps& c = facts.close_ups;
    c.picture = read_exr(folder / "picture.exr");
    if (c.region.width > c.picture.width - c.region.x || c.region.height > c.picture.height - c.region.y)
      return std::nullopt;
    c.reference = crop(c.picture, c.region);
    for (CloseUp& view : c.views) {
      view.crop = read_of_size(folder / fs::path(file_of(view)).filename(), c.region.width, c.region.height,
                               c.picture.channels);
      view.difference = absolute_difference(view.crop, c.reference);
      view.mse = compare(view.crop, c.reference).mse;
      view.flip = flip(view.crop, c.reference);
    }
    return std::move(facts.close_ups);
  } catch (const InputError&) {
    return std::nullopt;             // a report does without them
  } catch (const std::exception&) {  // JSON that says something else
    return std::nullopt;
  }
}

}  // namespace capcon
