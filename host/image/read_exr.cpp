#include <ImfChannelList.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <new>
#include <set>

#include "base/error.h"
#include "base/file.h"
#include "image/exr_check.h"
#include "image/exr_stream.h"
#include "image/image.h"

namespace capcon {
namespace {

constexpr int kRowsAtOnce = 256;  // at least the lines of a chunk of any compression

/// R G B, else Y, else the only channel that is neither alpha nor of a layer, else the only channel.
std::vector<std::string> choose_channels(const Imf::ChannelList& list) {
  std::vector<std::string> all;
  std::vector<std::string> plain;
  for (auto it = list.begin(); it != list.end(); ++it) {
    const std::string name = it.name();
    all.push_back(name);
    if (name != "A" && name.find('.') == std::string::npos) plain.push_back(name);
  }
  std::vector<std::string> chosen;
  if (list.findChannel("R") && list.findChannel("G") && list.findChannel("B")) {
    chosen = {"R", "G", "B"};
  } else if (list.findChannel("Y")) {
    chosen = {"Y"};
  } else if (plain.size() == 1) {
    chosen = plain;
  } else if (all.size() == 1) {
    chosen = all;
  } else {
    throw std::runtime_error(
        fmt::format("it has neither R, G, B nor Y nor a single channel but: {}", fmt::join(all, ", ")));
  }
  for (const std::string& name : chosen) {
    const Imf::Channel& channel = list[name.c_str()];
    if (channel.xSampling != 1 || channel.ySampling != 1) {
      throw std::runtime_error(fmt::format("its channel {} is subsampled, which is not supported", name));
    }
  }
  return chosen;
}

Attributes read_attributes(const Imf::Header& header) {
  static const std::set<std::string> kMechanics{"pixelAspectRatio", "screenWindowWidth", "name", "type",
                                                "version",          "chunkCount"};
  Attributes result;
  for (auto it = header.begin(); it != header.end(); ++it) {
    if (kMechanics.contains(it.name())) continue;
    const Imf::Attribute& attribute = it.attribute();
    if (const auto* i = dynamic_cast<const Imf::IntAttribute*>(&attribute)) result[it.name()] = i->value();
    if (const auto* f = dynamic_cast<const Imf::FloatAttribute*>(&attribute)) result[it.name()] = f->value();
    if (const auto* s = dynamic_cast<const Imf::StringAttribute*>(&attribute)) result[it.name()] = s->value();
  }
  return result;
}

Image read_pixels(Imf::InputFile& file) {
  const Imath::Box2i window = file.header().dataWindow();
  const std::vector<std::string> names = choose_channels(file.header().channels());
  Image image;
  image.width = window.max.x - window.min.x + 1;
  image.height = window.max.y - window.min.y + 1;
  image.channels = static_cast<int>(names.size());
  const std::size_t row = std::size_t(image.width) * image.channels;
  image.pixels.reserve(row * image.height);

  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < names.size(); ++c) {
    frame.insert(names[c], Imf::Slice::Make(Imf::FLOAT, image.pixels.data() + c, window,
                                            names.size() * sizeof(float), row * sizeof(float)));
  }
  file.setFrameBuffer(frame);
  // Block by block, so that a small broken file that claims to be large fails before its memory is touched.
  for (int y = 0; y < image.height; y += kRowsAtOnce) {
    const int end = std::min(image.height, y + kRowsAtOnce);
    image.pixels.resize(row * end);
    file.readPixels(window.min.y + y, window.min.y + end - 1);
  }
  return image;
}

}  // namespace

Image read_exr(const std::filesystem::path& path, Attributes* attributes) {
  const std::string bytes = read_file(path);
  const std::string name = path.filename().string();
  if (bytes.size() < 4 || bytes.compare(0, 4, "\x76\x2f\x31\x01") != 0) {
    throw InputError(path.string() + ": is not an EXR image; give an OpenEXR file");
  }
  try {
    check_exr(name, bytes);
    MemoryInput stream(name, bytes);
    Imf::InputFile file(stream);
    Image image = read_pixels(file);
    if (attributes) *attributes = read_attributes(file.header());
    return image;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(fmt::format("{}: cannot be read as an EXR image: {}", path.string(), error.what()));
  }
}

}  // namespace capcon
