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
#include <optional>

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

std::uint64_t big_endian(std::string_view bytes, std::size_t at) {
  std::uint64_t value = 0;
  for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

/// The file up to its chunk IEND, without empty chunks of pixels, which the format allows and stb copies to a
/// null pointer. Nothing when the header is not first, or a chunk is not as long as it says: stb takes memory
/// for that before it reads.
std::optional<std::string> whole_chunks(std::string_view bytes) {
  constexpr std::size_t kStart = 8, kAround = 12;  // length, name, checksum
  if (bytes.substr(kStart, 8) != std::string_view("\0\0\0\x0dIHDR", 8)) return std::nullopt;
  std::string kept(bytes.substr(0, kStart));
  for (std::size_t at = kStart; at + kAround <= bytes.size();) {
    const std::uint64_t length = big_endian(bytes, at);
    if (length > bytes.size() - at - kAround) return std::nullopt;
    const std::string_view chunk = bytes.substr(at, kAround + length), name = chunk.substr(4, 4);
    if (name != "IDAT" || length > 0) kept += chunk;
    if (name == "IEND") return kept;
    at += chunk.size();
  }
  return std::nullopt;
}

/// Whether the compressed data could be this image: deflate packs at most 1032 bytes into one.
bool is_long_enough(std::string_view bytes, std::int64_t width, std::int64_t height, int channels) {
  constexpr std::size_t kDepth = 24;  // in the first chunk, IHDR; a palette's pixels are one value each
  const std::int64_t depth = static_cast<unsigned char>(bytes[kDepth]);
  const bool palette = bytes[kDepth + 1] == 3;
  const std::int64_t row = (width * depth * (palette ? 1 : channels) + 7) / 8;
  return row * height <= std::int64_t(1032) * static_cast<std::int64_t>(bytes.size());
}

}  // namespace

Image read_png(const std::filesystem::path& path) {
  const std::string file = read_file(path);
  if (file.compare(0, 8, "\x89PNG\r\n\x1a\n") != 0 || file.size() > INT_MAX)
    throw InputError(path.string() + ": is not a PNG image; give a PNG file");
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("{}: cannot be read as a PNG image: {}", path.string(), why));
  };
  const std::optional<std::string> chunks = whole_chunks(file);
  if (!chunks) refuse("it is cut short or damaged");
  const std::string& bytes = *chunks;
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;  // the header alone first: no memory is taken for a size we refuse
  if (!stbi_info_from_memory(data, size, &width, &height, &channels))
    refuse("its header is broken or names a huge size");
  if (width < 1 || height < 1 || height > kMaxPixels / width)
    refuse(fmt::format("{} x {} pixels are more than 2^26", width, height));
  if (!is_long_enough(bytes, width, height, channels))
    refuse(fmt::format("it is too short for {} x {} pixels", width, height));
  const int wanted = channels <= 2 ? 1 : 3;
  const std::unique_ptr<stbi_us, void (*)(void*)> pixels(
      stbi_load_16_from_memory(data, size, &width, &height, &channels, wanted), stbi_image_free);
  if (!pixels) refuse(fmt::format("it is damaged ({})", stbi_failure_reason()));
  Image image(width, height, wanted);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = to_linear(pixels.get()[i]);
  return image;
}

}  // namespace capcon
