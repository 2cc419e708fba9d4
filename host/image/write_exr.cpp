#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIntAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <cassert>

#include "base/error.h"
#include "base/file.h"
#include "image/exr_stream.h"
#include "image/image.h"

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

void write_exr(const std::filesystem::path& path, const Image& image, const Attributes& attributes) {
  assert(image.width > 0 && image.height > 0 && (image.channels == 1 || image.channels == 3));
  assert(image.pixels.size() == std::size_t(image.width) * image.height * image.channels);
  MemoryOutput stream;
  try {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [name, value] : attributes) std::visit(InsertAttribute{header, name}, value);
    Imf::FrameBuffer frame;
    const std::size_t pixel = image.channels * sizeof(float);
    for (int c = 0; c < image.channels; ++c) {
      const char* name = image.channels == 1 ? "Y" : c == 0 ? "R" : c == 1 ? "G" : "B";
      header.channels().insert(name, Imf::Channel(Imf::FLOAT));
      frame.insert(name, Imf::Slice::Make(Imf::FLOAT, image.pixels.data() + c, header.dataWindow(), pixel,
                                          pixel * image.width));
    }
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(frame);
    file.writePixels(image.height);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw Failure(fmt::format("cannot write {}: {}", path.string(), error.what()));
  }
  write_file(path, stream.bytes());
}

}  // namespace capcon
