#include "plot/indexed_png.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <array>
#include <cassert>
#include <climits>
#include <memory>
#include <new>
#include <unordered_map>

#include "base/error.h"

namespace capcon::plot {
namespace {

constexpr std::size_t kColours = 256;
constexpr int kEffort = 32;  // length of the compressor's chains

std::uint32_t packed(Colour c) {
  return std::uint32_t(c.r) << 16 | std::uint32_t(c.g) << 8 | c.b;
}

/// Colours that fall together when `drop` low bits are left out: their sum and number.
struct Bucket {
  std::array<std::uint64_t, 3> sum{};
  std::uint64_t count = 0;
  std::uint32_t key = 0;

  Colour mean() const {
    const auto part = [this](int k) { return std::uint8_t((sum[k] + count / 2) / count); };
    return {part(0), part(1), part(2)};
  }
};

std::vector<Bucket> buckets_of(const Pixels& pixels, std::uint32_t mask) {
  std::unordered_map<std::uint32_t, Bucket> found;
  for (const Colour& c : pixels.colours) {
    Bucket& bucket = found[packed(c) & mask];
    bucket.sum[0] += c.r, bucket.sum[1] += c.g, bucket.sum[2] += c.b;
    ++bucket.count;
  }
  std::vector<Bucket> buckets;
  for (auto& [key, bucket] : found) {
    bucket.key = key;
    buckets.push_back(bucket);
  }
  std::sort(buckets.begin(), buckets.end(), [](const Bucket& a, const Bucket& b) {
    return a.count != b.count ? a.count > b.count : a.key < b.key;
  });
  return buckets;
}

struct Palette {
  std::vector<Colour> colours;
  std::unordered_map<std::uint32_t, std::uint8_t> index;  ///< by masked colour
  std::uint32_t mask = 0xffffff;
};

Palette palette_of(const Pixels& pixels) {
  Palette palette;
  std::vector<Bucket> buckets = buckets_of(pixels, palette.mask);
  if (buckets.size() > kColours) {
    palette.mask = 0xf8f8f8;
    buckets = buckets_of(pixels, palette.mask);
  }
  for (std::size_t k = 0; k < std::min(buckets.size(), kColours); ++k)
    palette.colours.push_back(buckets[k].mean());
  for (std::size_t k = 0; k < buckets.size(); ++k) {
    const Colour wanted = buckets[k].mean();
    const auto distance = [&](Colour c) {
      const int r = c.r - wanted.r, g = c.g - wanted.g, b = c.b - wanted.b;
      return r * r + g * g + b * b;
    };
    const auto nearest = std::min_element(palette.colours.begin(), palette.colours.end(),
                                          [&](Colour a, Colour b) { return distance(a) < distance(b); });
    palette.index[buckets[k].key] =
        std::uint8_t(k < kColours ? k : std::size_t(nearest - palette.colours.begin()));
  }
  return palette;
}

void append32(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += char(value >> shift & 255);
}

/// Length, name, data and their CRC-32 (ISO 3309), as PNG wants them.
void append_chunk(std::string& png, const char* name, std::string_view data) {
  append32(png, std::uint32_t(data.size()));
  const std::size_t start = png.size();
  png += name;
  png += data;
  std::uint32_t crc = ~0u;
  for (std::size_t k = start; k < png.size(); ++k) {
    crc ^= static_cast<unsigned char>(png[k]);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
  }
  append32(png, ~crc);
}

}  // namespace

std::string encode_png(const Pixels& pixels) {
  assert(pixels.width > 0 && pixels.height > 0);
  if ((std::int64_t(pixels.width) + 1) * pixels.height > INT_MAX / 4)
    throw Failure("the picture is too large for a PNG");
  const Palette palette = palette_of(pixels);
  std::string rows, plte, header;
  for (int y = 0; y < pixels.height; ++y) {
    rows += char(0);  // no filter: neighbouring numbers mean nothing
    for (int x = 0; x < pixels.width; ++x) {
      const std::uint32_t colour = packed(pixels.colours[std::size_t(y) * pixels.width + x]);
      rows += char(palette.index.at(colour & palette.mask));
    }
  }
  for (const Colour& c : palette.colours) plte += {char(c.r), char(c.g), char(c.b)};
  append32(header, std::uint32_t(pixels.width));
  append32(header, std::uint32_t(pixels.height));
  header += {8, 3, 0, 0, 0};  // bits, palette, deflate, filters, not interlaced
  int size = 0;
  const std::unique_ptr<unsigned char, decltype(&std::free)> compressed(
      stbi_zlib_compress(reinterpret_cast<unsigned char*>(rows.data()), int(rows.size()), &size, kEffort),
      &std::free);
  if (!compressed) throw std::bad_alloc();
  std::string png = "\x89PNG\r\n\x1a\n";
  append_chunk(png, "IHDR", header);
  append_chunk(png, "PLTE", plte);
  append_chunk(png, "IDAT", {reinterpret_cast<const char*>(compressed.get()), std::size_t(size)});
  append_chunk(png, "IEND", {});
  return png;
}

}  // namespace capcon::plot
