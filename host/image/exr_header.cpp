#include "image/exr_header.h"

#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFloatAttribute.h>
#include <ImfIntAttribute.h>
#include <ImfStringAttribute.h>

namespace capcon {
namespace {

struct InsertAttribute {
  Imf::Header& header;
  const std::string& name;

  void operator()(int value) const { header.insert(name, Imf::IntAttribute(value)); }
  void operator()(float value) const { header.insert(name, Imf::FloatAttribute(value)); }
  void operator()(const std::string& value) const { header.insert(name, Imf::StringAttribute(value)); }
};

}  // namespace

Imf::Header exr_header(int width, int height, int channels, const Attributes& attributes) {
  Imf::Header header(width, height);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const auto& [name, value] : attributes) std::visit(InsertAttribute{header, name}, value);
  for (int c = 0; c < channels; ++c)
    header.channels().insert(exr_channel(channels, c), Imf::Channel(Imf::FLOAT));
  return header;
}

const char* exr_channel(int channels, int index) {
  constexpr const char* kColours[] = {"R", "G", "B"};
  return channels == 1 ? "Y" : kColours[index];
}

}  // namespace capcon
