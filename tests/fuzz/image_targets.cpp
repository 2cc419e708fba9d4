// Images as textures, environments, densities and references are read; and rows of a stopped render.
#include <cmath>
#include <cstring>

#include "base/hash.h"
#include "fuzz/files.h"
#include "fuzz/target.h"
#include "image/image.h"
#include "image/partial_image.h"
#include "points/density.h"

namespace capcon::fuzz {
namespace {

void check_image(const Image& image) {
  require(image.width >= 1 && image.height >= 1, "an image has pixels");
  require(image.channels == 1 || image.channels == 3, "an image is grey or has three colours");
  require(image.pixels.size() == std::size_t(image.width) * image.height * image.channels,
          "an image has all its pixels");
  if (image.width > 256 || image.height > 256) return;
  std::vector<double> values;
  for (std::size_t i = 0; i < image.pixels.size(); i += image.channels) values.push_back(image.pixels[i]);
  const Density density(image.width, image.height, std::move(values));
  for (const glm::dvec2 u : {glm::dvec2(0), glm::dvec2(0.25, 0.75), glm::dvec2(1 - 0x1p-53)}) {
    const glm::dvec2 at = density.warp(u);
    require(at.x >= 0 && at.x < 1 && at.y >= 0 && at.y < 1, "a warped point stays in the square");
  }
}

constexpr std::string_view kPartialHead = "capcon-partial 1 0000000000000007 3 4 1\n";

/// The records with checksums that fit, which no mutation finds.
std::string with_checksums(std::string_view records) {
  std::string bytes(records);
  for (std::size_t at = 0; bytes.size() - at >= 16;) {
    std::uint32_t rows = 0;
    std::memcpy(&rows, bytes.data() + at + 4, 4);
    const std::size_t size = std::size_t(rows) * 3 * 4;
    if (size > bytes.size() - at - 16) break;
    const std::uint64_t sum = fnv1a64(std::string_view(bytes).substr(at + 16, size));
    std::memcpy(bytes.data() + at + 8, &sum, 8);
    at += 16 + size;
  }
  return bytes;
}

void check_partial(const std::string& bytes) {
  const std::filesystem::path path = scratch_folder() / "rows.partial";
  write_plain(path, bytes);
  std::size_t values = 0;
  {
    PartialImage image(path, 7, 3, 4, 1);
    for (int row = 0; row < 4; ++row)
      if (!image.has(row, 1) && image.row_count() < 4) image.add(row, std::vector<float>(3, 1.0f));
    if (image.row_count() == 4) image.read([&](std::span<const float> row) { values += row.size(); });
    require(image.row_count() != 4 || values == 12, "four rows are all values");
  }
  PartialImage image(path, 7, 3, 4, 1);
  require(image.row_count() >= 1, "what was added is there again");
}

}  // namespace

void read_exr_image(std::string_view bytes) {
  const MemoryFile file(bytes);
  Attributes attributes;
  check_image(read_exr(file.path(), &attributes));
}

void read_png_image(std::string_view bytes) {
  const MemoryFile file(bytes);
  const Image image = read_png(file.path());
  for (const float value : image.pixels) require(value >= 0 && value <= 1, "a PNG's values are in [0, 1]");
  check_image(image);
}

void read_partial(std::string_view bytes) {
  check_partial(std::string(bytes));
  check_partial(std::string(kPartialHead) + with_checksums(bytes));
}

}  // namespace capcon::fuzz
