#include <ImfFrameBuffer.h>
#include <ImfOutputFile.h>
#include <fmt/format.h>

#include <cassert>

#include "base/error.h"
#include "base/file.h"
#include "image/exr_header.h"
#include "image/exr_stream.h"
#include "image/image.h"

namespace capcon {

void write_exr(const std::filesystem::path& path, const Image& image, const Attributes& attributes) {
  assert(image.width > 0 && image.height > 0 && (image.channels == 1 || image.channels == 3));
  assert(image.pixels.size() == std::size_t(image.width) * image.height * image.channels);
  MemoryOutput stream;
  try {
    const Imf::Header header = exr_header(image.width, image.height, image.channels, attributes);
    Imf::FrameBuffer frame;
    const std::size_t pixel = image.channels * sizeof(float);
    for (int c = 0; c < image.channels; ++c) {
      frame.insert(exr_channel(image.channels, c),
                   Imf::Slice::Make(Imf::FLOAT, image.pixels.data() + c, header.dataWindow(), pixel,
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
