#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

#include <fmt/format.h>

#include <climits>
#include <cmath>
#include <memory>

#include "base/error.h"
#include "base/file.h"
#include "image/image.h"

namespace capcon {
namespace {

constexpr std::int64_t kMaxPixels = std::int64_t(1) << 26;

/// The inverse of the transfer function of IEC 61966-2-1 (sRGB).
float to_linear(std::uint16_t value) {
  const double v = value / 65535.0;
  return static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
}

}  // namespace

Image read_png(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  if (bytes.compare(0, 8, "\x89PNG\r\n\x1a\n") != 0 || bytes.size() > INT_MAX)
    throw InputError(path.string() + ": is not a PNG image; give a PNG file");
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("{}: cannot be read as a PNG image: {}", path.string(), why));
  };
  int width = 0, height = 0, channels = 0;  // the header alone first: no memory is taken for a size we refuse
  if (!stbi_info_from_memory(data, size, &width, &height, &channels))
    refuse("its header is broken or names a huge size");
  if (width < 1 || height < 1 || height > kMaxPixels / width)
    refuse(fmt::format("{} x {} pixels are more than 2^26", width, height));
  const int wanted = channels <= 2 ? 1 : 3;
  const std::unique_ptr<stbi_us, void (*)(void*)> pixels(
      stbi_load_16_from_memory(data, size, &width, &height, &channels, wanted), stbi_image_free);
  if (!pixels) refuse(fmt::format("it is damaged ({})", stbi_failure_reason()));
  Image image(width, height, wanted);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = to_linear(pixels.get()[i]);
  return image;
}

}  // namespace capcon
