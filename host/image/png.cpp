#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <fmt/format.h>
#include <stb/stb_image_write.h>

#include <algorithm>
#include <cassert>
#include <climits>
#include <cmath>

#include "base/error.h"
#include "base/file.h"
#include "image/deflate.h"
#include "image/image.h"

namespace capcon {
namespace {

/// The transfer function of IEC 61966-2-1 (sRGB), to a byte.
unsigned char to_srgb(float linear) {
  const double v = std::clamp(static_cast<double>(linear), 0.0, 1.0);
  const double s = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
  return static_cast<unsigned char>(std::lround(255 * s));
}

void append(void* context, void* data, int size) {
  static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

}  // namespace

std::string encode_png(const Image& image, float exposure) {
  assert(image.width > 0 && image.height > 0 && (image.channels == 1 || image.channels == 3));
  const bool finite =
      std::all_of(image.pixels.begin(), image.pixels.end(), [](float v) { return std::isfinite(v); });
  const int channels =
      image.channels == 1 && finite ? 1 : 3;  // a grey image with a hole needs colour to show it
  if ((std::int64_t(image.width) * channels + 1) * image.height > INT_MAX / 4) {
    throw Failure(
        fmt::format("an image of {} x {} pixels is too large for a PNG preview; write an EXR instead",
                    image.width, image.height));
  }
  std::vector<unsigned char> bytes;
  bytes.reserve(std::size_t(image.width) * image.height * channels);
  for (std::size_t i = 0; i < image.pixels.size(); i += image.channels) {
    const float* pixel = &image.pixels[i];
    const bool good = std::all_of(pixel, pixel + image.channels, [](float v) { return std::isfinite(v); });
    for (int c = 0; c < channels; ++c) {
      const unsigned char magenta = c == 1 ? 0 : 255;
      bytes.push_back(good ? to_srgb(pixel[std::min(c, image.channels - 1)] * exposure) : magenta);
    }
  }
  std::string png;
  if (!stbi_write_png_to_func(append, &png, image.width, image.height, channels, bytes.data(), 0))
    throw std::bad_alloc();
  return png;
}

std::string deflated(std::string_view bytes) {
  // What stb's PNGs are made with: it reads and does not write.
  auto* data = const_cast<unsigned char*>(reinterpret_cast<const unsigned char*>(bytes.data()));
  int length = 0;
  constexpr int kQuality = 16;
  unsigned char* result = stbi_zlib_compress(data, static_cast<int>(bytes.size()), &length, kQuality);
  if (!result) throw std::bad_alloc();
  std::string text(reinterpret_cast<char*>(result), static_cast<std::size_t>(length));
  STBIW_FREE(result);
  return text;
}

void write_png(const std::filesystem::path& path, const Image& image, float exposure) {
  write_file(path, encode_png(image, exposure));
}

}  // namespace capcon
