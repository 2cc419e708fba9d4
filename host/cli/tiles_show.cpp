#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/common.hpp>
#include <memory>

#include "base/error.h"
#include "base/file.h"
#include "cli/tiles_verb.h"
#include "image/image.h"
#include "tiling/tiling_picture.h"

namespace capcon::cli {
namespace {

struct Options {
  std::string file, output;
  std::uint32_t width = 4, ranks = 0, size = 800;
  std::uint64_t seed = 1;
};

float to_linear(std::uint8_t srgb) {
  const double v = srgb / 255.0;
  return float(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
}

// Paints over the pixels around [low, high] with the coverage that `distance` (to the shape's edge, negative
// inside) gives each of them.
template <typename Distance>
void paint(Image& image, glm::dvec2 low, glm::dvec2 high, TilingPicture::Colour colour, Distance distance) {
  const int x0 = std::max(0, int(low.x) - 1), x1 = std::min(image.width - 1, int(high.x) + 1);
  const int y0 = std::max(0, int(low.y) - 1), y1 = std::min(image.height - 1, int(high.y) + 1);
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const auto cover = float(std::clamp(0.5 - distance(glm::dvec2(x + 0.5, y + 0.5)), 0.0, 1.0));
      for (int c = 0; c < 3; ++c) image.at(x, y, c) += cover * (to_linear(colour[c]) - image.at(x, y, c));
    }
}

Image rasterise(const TilingPicture& picture) {
  const int size = int(picture.size);
  Image image(size, size, 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = to_linear(picture.background[i % 3]);
  for (const TilingPicture::Line& line : picture.lines) {
    const glm::dvec2 along = line.to - line.from;
    const double length2 = std::max(1e-12, along.x * along.x + along.y * along.y);
    paint(image, glm::min(line.from, line.to) - line.width, glm::max(line.from, line.to) + line.width,
          line.colour, [&](glm::dvec2 p) {
            const glm::dvec2 d = p - line.from;
            const double t = std::clamp((d.x * along.x + d.y * along.y) / length2, 0.0, 1.0);
            return std::hypot(d.x - t * along.x, d.y - t * along.y) - line.width / 2;
          });
  }
  for (const TilingPicture::Disc& disc : picture.discs)
    paint(image, disc.centre - disc.radius, disc.centre + disc.radius, disc.colour,
          [&](glm::dvec2 p) { return std::hypot(p.x - disc.centre.x, p.y - disc.centre.y) - disc.radius; });
  return image;
}

void run(const Options& options) {
  const TileSet set = named_tile_set(options.file);
  const std::string extension = std::filesystem::path(options.output).extension().string();
  if (!options.output.empty() && extension != ".svg" && extension != ".png")
    throw InputError(fmt::format("{}: a picture is written as .svg or .png", options.output));
  if (options.ranks > set.points_per_tile)
    throw InputError(
        fmt::format("--ranks {}: a tile of this set has {} points", options.ranks, set.points_per_tile));
  const std::uint32_t ranks = options.ranks == 0 ? set.points_per_tile : options.ranks;
  const TilingPicture picture = picture_tiling(set, options.width, ranks, options.seed, options.size);
  if (options.output.empty())
    fmt::print("{}", to_svg(picture));
  else if (extension == ".png")
    write_png(options.output, rasterise(picture));
  else
    write_file(options.output, to_svg(picture));
}

}  // namespace

void add_tiles_show(CLI::App& tiles) {
  CLI::App* verb = tiles.add_subcommand("show",
                                        "draw a random tiling: points, their Voronoi cells, tiles and corner "
                                        "colours\n\n"
                                        "  capcon tiles show shipped --width 4 -o tiling.png\n");
  auto options = std::make_shared<Options>();
  verb->add_option("file", options->file, "a tile set's file, or: shipped")->required()->type_name("FILE");
  verb->add_option("--width", options->width, "tiles along a side")
      ->capture_default_str()
      ->check(CLI::Range(1, 64));
  verb->add_option("--seed", options->seed, "of the corner colours")->capture_default_str();
  verb->add_option("--ranks", options->ranks, "only the first points of every tile (0: all)")
      ->capture_default_str();
  verb->add_option("--size", options->size, "pixels along a side")
      ->capture_default_str()
      ->check(CLI::Range(16, 16384));
  verb->add_option("-o,--output", options->output, ".svg or .png (default: SVG on standard output)")
      ->type_name("FILE");
  verb->callback([options] { run(*options); });
}

}  // namespace capcon::cli
