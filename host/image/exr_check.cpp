#include "image/exr_check.h"

#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfPartType.h>
#include <ImfTileDescription.h>
#include <ImfVersion.h>
#include <ImfXdr.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string_view>

#include "base/little_endian.h"
#include "image/exr_stream.h"

namespace capcon {
namespace {

constexpr std::int64_t kMaxPixels = std::int64_t(1) << 28;
constexpr std::string_view kTooShort = "it is too short for what its header says; is it truncated?";

[[noreturn]] void refuse(const std::string& phrase) {
  throw std::runtime_error(phrase);
}

/// A name or a type, which ends with a zero byte.
std::string_view take_name(std::string_view& bytes) {
  const std::size_t end = bytes.find('\0');
  if (end == bytes.npos) refuse("its header does not end");
  const std::string_view name = bytes.substr(0, end);
  bytes.remove_prefix(end + 1);
  return name;
}

/// Bytes that OpenEXR reads of an attribute of this type, whatever length stands there; 0 where it reads that
/// length. (OpenEXR 3.1, ImfHeader.cpp lists the types that it knows.)
std::uint32_t bytes_of_type(std::string_view type) {
  static const std::map<std::string_view, std::uint32_t> kSizes = {{"box2f", 16},
                                                                   {"box2i", 16},
                                                                   {"chromaticities", 32},
                                                                   {"compression", 1},
                                                                   {"deepImageState", 1},
                                                                   {"double", 8},
                                                                   {"envmap", 1},
                                                                   {"float", 4},
                                                                   {"int", 4},
                                                                   {"keycode", 28},
                                                                   {"lineOrder", 1},
                                                                   {"m33d", 72},
                                                                   {"m33f", 36},
                                                                   {"m44d", 128},
                                                                   {"m44f", 64},
                                                                   {"rational", 8},
                                                                   {"tiledesc", 9},
                                                                   {"timecode", 8},
                                                                   {"v2d", 16},
                                                                   {"v2f", 8},
                                                                   {"v2i", 8},
                                                                   {"v3d", 24},
                                                                   {"v3f", 12},
                                                                   {"v3i", 12}};
  const auto found = kSizes.find(type);
  return found == kSizes.end() ? 0 : found->second;
}

/// Whether these bytes are a list of channels and nothing else.
bool is_channel_list(std::string_view bytes) {
  constexpr std::size_t kChannel = 16;
  while (!take_name(bytes).empty()) {
    if (bytes.size() < kChannel) return false;
    bytes.remove_prefix(kChannel);
  }
  return bytes.empty();
}

/// Whether these bytes are a preview image: its size and four bytes a pixel.
bool is_preview(std::string_view bytes) {
  if (bytes.size() < 8) return false;
  const std::uint64_t width = take_bytes<std::uint32_t>(bytes), height = take_bytes<std::uint32_t>(bytes);
  return width <= bytes.size() && height <= bytes.size() && 4 * width * height == bytes.size();
}

/// Whether these bytes are strings, each behind its length.
bool is_strings(std::string_view bytes) {
  while (bytes.size() >= 4) {
    const auto length = take_bytes<std::uint32_t>(bytes);
    if (length > bytes.size()) return false;
    bytes.remove_prefix(length);
  }
  return bytes.empty();
}

/// Whether OpenEXR reads what the length says, and takes no more memory.
bool fits(std::string_view type, std::string_view value) {
  if (type == "chlist") return is_channel_list(value);
  if (type == "preview") return is_preview(value);
  if (type == "stringvector") return is_strings(value);
  if (type == "floatvector") return value.size() % 4 == 0;  // of others it reads less
  const std::uint32_t expected = bytes_of_type(type);
  return expected == 0 || value.size() == expected;
}

/// The attributes of one header by their lengths.
void walk_header(std::string_view& bytes) {
  while (!take_name(bytes).empty()) {
    const std::string_view type = take_name(bytes);
    if (bytes.size() < 4) refuse("its header does not end");
    const auto length = take_bytes<std::uint32_t>(bytes);
    if (type == "idmanifest") refuse("it holds a manifest of ids, which is not supported");
    if (length > bytes.size() || !fits(type, bytes.substr(0, length)))
      refuse("its header is damaged: an attribute has a wrong length");
    bytes.remove_prefix(length);
  }
}

void check_dimensions(const char* what, std::int64_t width, std::int64_t height) {
  if (width < 1 || height < 1 || height > kMaxPixels / width)
    refuse(fmt::format("its {} of {} x {} pixels is not one this program reads", what, width, height));
}

constexpr double kFree = 0x1p26;  ///< bytes, whatever the file's length

/// Lines of a chunk, and how many bytes at most become one (deflate: 1032, of which PXR24 makes 4/3; the
/// others pack a black chunk of any size into some 40 bytes; whoever has larger ones than kFree may use
/// deflate).
struct Packing {
  int lines;
  double ratio;
};

Packing packing_of(Imf::Compression compression) {
  switch (compression) {
    case Imf::NO_COMPRESSION:
      return {1, 1};
    case Imf::RLE_COMPRESSION:
      return {1, 128};
    case Imf::ZIPS_COMPRESSION:
      return {1, 1400};
    case Imf::ZIP_COMPRESSION:
    case Imf::PXR24_COMPRESSION:
      return {16, 1400};
    case Imf::DWAB_COMPRESSION:
      return {256, 0x1p16};
    default:
      return {32, 0x1p16};
  }
}

/// Bytes of all pixels when unpacked.
double unpacked_bytes(const Imf::Header& header, double width, double height) {
  double bytes = 0;
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
    const Imf::Channel& channel = it.channel();
    const double of_one = channel.type == Imf::HALF ? 2 : 4;
    bytes += of_one * std::ceil(width / std::max(1, channel.xSampling)) *
             std::ceil(height / std::max(1, channel.ySampling));
  }
  return bytes;
}

void check_header(const Imf::Header& header, std::size_t file_bytes) {
  if (header.hasType() && Imf::isDeepData(header.type()))
    refuse("it holds deep data, which is not supported");
  const Imath::Box2i window = header.dataWindow();
  const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1;
  const std::int64_t height = std::int64_t(window.max.y) - window.min.y + 1;
  check_dimensions("size", width, height);
  const Packing packing = packing_of(header.compression());
  std::int64_t chunks = (height + packing.lines - 1) / packing.lines;
  if (header.hasTileDescription()) {
    const std::int64_t w = header.tileDescription().xSize;
    const std::int64_t h = header.tileDescription().ySize;
    check_dimensions("tile size", w, h);
    chunks = ((width + w - 1) / w) * ((height + h - 1) / h);
    if (unpacked_bytes(header, w, h) > kFree + packing.ratio * file_bytes) refuse(std::string(kTooShort));
  }
  constexpr std::int64_t kEntry = 8;  // of the table of chunks; OpenEXR takes memory for all lines of one
  if (chunks > static_cast<std::int64_t>(file_bytes) / kEntry ||
      unpacked_bytes(header, width, std::max<std::int64_t>(height, packing.lines)) >
          kFree + packing.ratio * file_bytes)
    refuse(std::string(kTooShort));
}

}  // namespace

void check_exr(const std::string& name, const std::string& bytes) {
  MemoryInput stream(name, bytes);
  int magic = 0;
  int version = 0;
  Imf::Xdr::read<Imf::StreamIO>(stream, magic);
  Imf::Xdr::read<Imf::StreamIO>(stream, version);
  if (Imf::isNonImage(version)) refuse("it holds deep data, which is not supported");
  std::string_view rest = std::string_view(bytes).substr(8);
  do {
    const std::string_view before = rest;
    walk_header(rest);
    if (before.size() - rest.size() == 1) return;  // the empty header behind the last part
    Imf::Header header;
    header.readFrom(stream, version);
    check_header(header, bytes.size());
  } while (Imf::isMultiPart(version));
}

}  // namespace capcon
