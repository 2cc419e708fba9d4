#include "cli/density_option.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/error.h"
#include "image/image.h"
#include "points/formula.h"

namespace capcon::cli {
namespace {

Density of_image(const std::string& file, const Image& image) {
  std::vector<double> values(static_cast<std::size_t>(image.width) * image.height);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float* pixel = &image.pixels[i * image.channels];
    // Luminance of linear Rec. 709 colours.
    values[i] = image.channels == 3 ? 0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2] : pixel[0];
  }
  try {
    return {static_cast<std::size_t>(image.width), static_cast<std::size_t>(image.height), std::move(values)};
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file, error.what()));
  }
}

}  // namespace

std::shared_ptr<const Density> read_density(const std::string& text) {
  std::string ending = std::filesystem::path(text).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (ending == ".exr") return std::make_shared<Density>(of_image(text, read_exr(text)));
  if (ending == ".png") return std::make_shared<Density>(of_image(text, read_png(text)));
  const Formula formula = [&] {
    std::error_code ignored;
    try {
      return Formula(text);
    } catch (const InputError&) {
      if (!std::filesystem::is_regular_file(text, ignored)) throw;
      throw InputError(text + ": not an image this program reads; give .exr or .png, or a formula");
    }
  }();
  return std::make_shared<Density>(Density::of([&](double x, double y) { return formula(x, y); }));
}

}  // namespace capcon::cli
