#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace capcon {

/// A float image, row by row from the top, channels interleaved (1 = grey, 3 = RGB), linear.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<float> pixels;

  Image() = default;
  Image(int w, int h, int c) : width(w), height(h), channels(c), pixels(std::size_t(w) * h * c) {}
  float& at(int x, int y, int c) { return pixels[(std::size_t(y) * width + x) * channels + c]; }
  float at(int x, int y, int c) const { return pixels[(std::size_t(y) * width + x) * channels + c]; }
};

/// EXR header attributes by name, as int, float or string. pbrt-v4's names: samplesPerPixel (int),
/// renderTimeSeconds (float), MSE (float); ours besides: sampler, seed, device, integrator, radius, timings
/// (JSON text).
using Attributes = std::map<std::string, std::variant<int, float, std::string>>;

/// Reads R, G, B (or Y, or a single channel) of a scan line or tiled EXR of any pixel type as float.
/// InputError for a missing, broken or unsupported file.
Image read_exr(const std::filesystem::path& path, Attributes* attributes = nullptr);

/// Writes 32-bit float, ZIP, channels R G B (three) or Y (one); complete or not at all.
void write_exr(const std::filesystem::path& path, const Image& image, const Attributes& attributes = {});

/// Reads a PNG of 8 or 16 bits, grey, RGB or with a palette, as linear values in [0, 1] (1 channel if it is
/// grey, else 3); sRGB is assumed, alpha is dropped. InputError for a missing, broken or larger file than
/// 2^26 pixels.
Image read_png(const std::filesystem::path& path);

/// Writes an 8-bit sRGB preview after multiplying by `exposure`; complete or not at all.
void write_png(const std::filesystem::path& path, const Image& image, float exposure = 1);

/// The same preview as bytes, for embedding into a page.
std::string encode_png(const Image& image, float exposure = 1);

}  // namespace capcon
