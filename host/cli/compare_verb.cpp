#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/error.h"
#include "base/file.h"
#include "cli/verbs.h"
#include "image/compare.h"
#include "image/flip.h"
#include "image/image.h"

namespace capcon::cli {
namespace {

struct Options {
  std::string image;
  std::string reference;
  std::string output;
  double tolerance = Comparison{}.tolerance;
  bool flip = false;
  bool json = false;
};

constexpr std::size_t kFlipPixels = 1u << 20;  // more take longer than all else together

Image absolute_difference(const Image& a, const Image& b) {
  Image result(a.width, a.height, std::max(a.channels, b.channels));
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      for (int c = 0; c < result.channels; ++c) {
        result.at(x, y, c) =
            std::abs(a.at(x, y, a.channels == 1 ? 0 : c) - b.at(x, y, b.channels == 1 ? 0 : c));
      }
    }
  }
  return result;
}

/// How different the two look.
struct Looks {
  double flip = 0;
  HdrFlip hdr;
};

void print_table(const Comparison& c, const std::optional<Looks>& looks) {
  const auto line = [](const std::string& name, const std::string& value, const char* meaning) {
    fmt::print("{:<16} {:>12}  {}\n", name, value, meaning);
  };
  const auto number = [](double v) { return fmt::format("{:.6g}", v); };
  line("mse", number(c.mse), "mean of (a - b)^2");
  line("mse clamped", number(c.mse_clamped), "both clamped to [0, 1]");
  line("mse trimmed", number(c.mse_trimmed), "without the worst 1 % of pixels");
  line("relmse", number(c.relmse), "mean of (a - b)^2 / (b^2 + 0.01), b the reference");
  if (looks) {
    line("flip", number(looks->flip), "how different they look at exposure 1: mean of LDR-FLIP, 0 to 1");
    line("flip hdr", number(looks->hdr.value),
         fmt::format("the same, the worst of {} exposures from 2^{:.1f} to 2^{:.1f}", looks->hdr.exposures,
                     looks->hdr.start, looks->hdr.stop)
             .c_str());
  } else {
    line("flip", "–", "left out of images as large as these; --flip measures it");
  }
  line("max difference", number(c.max_difference), "largest |a - b|");
  line("mean difference", number(c.mean_difference), "mean of a - b");
  line("beyond", number(c.beyond),
       fmt::format("fraction of pixels that differ by more than {:g}", c.tolerance).c_str());
  line("non-finite", fmt::format("{}", c.non_finite), "pixels that are not finite, left out of the rest");
}

void run(const Options& options) {
  const std::filesystem::path output = options.output;
  if (!output.empty()) {
    if (output.extension() != ".exr" && output.extension() != ".png") {
      throw InputError(output.string() + ": name the difference image .exr or .png");
    }
    check_writable(output);
  }
  const Image image = read_exr(options.image);
  const Image reference = read_exr(options.reference);
  if (image.width != reference.width || image.height != reference.height) {
    throw InputError(fmt::format("{} has {}x{} pixels and {} has {}x{}; compare images of one size",
                                 options.image, image.width, image.height, options.reference, reference.width,
                                 reference.height));
  }
  const Comparison comparison = compare(image, reference, options.tolerance);
  if (output.extension() == ".exr") write_exr(output, absolute_difference(image, reference));
  if (output.extension() == ".png") write_png(output, absolute_difference(image, reference));
  std::optional<Looks> looks;
  if (options.flip || std::size_t(image.width) * image.height <= kFlipPixels)
    looks = Looks{flip(image, reference), hdr_flip(image, reference)};
  if (options.json) {
    nlohmann::json json = to_json(comparison);
    if (looks) {
      json["flip"] = looks->flip;
      json["flip_pixels_per_degree"] = kFlipPixelsPerDegree;
      json["hdr_flip"] = {{"value", looks->hdr.value},
                          {"exposures", looks->hdr.exposures},
                          {"start", looks->hdr.start},
                          {"stop", looks->hdr.stop}};
    }
    fmt::print("{}\n", json.dump(2));
  } else {
    print_table(comparison, looks);
  }
}

}  // namespace

void add_compare_verb(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("compare", "how far an image is from a reference image");
  auto options = std::make_shared<Options>();
  verb->footer(
      "Examples:\n  capcon compare out.exr reference.exr\n  capcon compare out.exr reference.exr -o "
      "difference.png");
  verb->add_option("image", options->image, "EXR image")->required();
  verb->add_option("reference", options->reference, "EXR image of the same size")->required();
  verb->add_option("-o,--output", options->output, "write |a - b| as an .exr or .png image");
  verb->add_option("--tolerance", options->tolerance, "a difference that counts as none")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  verb->add_flag("--flip", options->flip, "measure FLIP of images above a million pixels too");
  verb->add_flag("--json", options->json, "print one JSON object");
  verb->callback([options] { run(*options); });
}

}  // namespace capcon::cli
