#include "image/exr_rows.h"

#include <ImfFrameBuffer.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <fmt/format.h>

#include <cassert>
#include <cerrno>
#include <cstdio>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/file.h"
#include "image/exr_header.h"

namespace capcon {
namespace {

/// A file that says when it cannot be written; OpenEXR's own stream keeps silent about what fails when it is
/// closed.
class FileOutput : public Imf::OStream {
 public:
  explicit FileOutput(const std::filesystem::path& path)
      : OStream(path.c_str()), file_(std::fopen(path.c_str(), "wb")) {
    check(file_ != nullptr);
  }
  ~FileOutput() override {
    if (file_) std::fclose(file_);
  }

  void write(const char c[], int n) override {
    const auto bytes = static_cast<std::size_t>(n);
    check(std::fwrite(c, 1, bytes, file_) == bytes);
  }
  std::uint64_t tellp() override { return static_cast<std::uint64_t>(::ftello(file_)); }
  void seekp(std::uint64_t place) override {
    check(::fseeko(file_, static_cast<off_t>(place), SEEK_SET) == 0);
  }

  void close() {
    std::FILE* file = file_;
    file_ = nullptr;
    check(std::fclose(file) == 0);
  }

 private:
  static void check(bool good) {
    if (!good) throw std::runtime_error(reason_of(errno));
  }
  std::FILE* file_;
};

}  // namespace

struct ExrRows::State {
  std::filesystem::path target;
  PendingFile pending;
  Imf::Header header;
  FileOutput stream;
  std::unique_ptr<Imf::OutputFile> file;
  int width, channels;
  int next_row = 0;

  State(const std::filesystem::path& path, int w, int h, int c, const Attributes& attributes)
      : target(path),
        pending(path),
        header(exr_header(w, h, c, attributes)),
        stream(pending.path()),
        file(std::make_unique<Imf::OutputFile>(stream, header)),
        width(w),
        channels(c) {}

  Failure failure(const std::exception& error) const {
    return Failure(fmt::format("cannot write {}: {}", target.string(), error.what()));
  }
};

ExrRows::ExrRows(const std::filesystem::path& path, int width, int height, int channels,
                 const Attributes& attributes) {
  assert(width > 0 && height > 0 && (channels == 1 || channels == 3));
  try {
    state_ = std::make_unique<State>(path, width, height, channels, attributes);
  } catch (const Failure&) {
    throw;
  } catch (const std::exception& error) {
    throw Failure(fmt::format("cannot write {}: {}", path.string(), error.what()));
  }
}

ExrRows::~ExrRows() = default;

void ExrRows::write(std::span<const float> pixels) {
  State& s = *state_;
  const std::size_t row = std::size_t(s.width) * s.channels;
  assert(pixels.size() % row == 0);
  const int rows = static_cast<int>(pixels.size() / row);
  try {
    Imf::FrameBuffer frame;
    const std::size_t pixel = s.channels * sizeof(float);
    // A slice is addressed by the file's own rows: its origin is the first of these.
    const Imath::Box2i window({0, s.next_row}, {s.width - 1, s.next_row + rows - 1});
    for (int c = 0; c < s.channels; ++c) {
      frame.insert(exr_channel(s.channels, c),
                   Imf::Slice::Make(Imf::FLOAT, pixels.data() + c, window, pixel, pixel * s.width));
    }
    s.file->setFrameBuffer(frame);
    s.file->writePixels(rows);
    s.next_row += rows;
  } catch (const std::exception& error) {
    throw s.failure(error);
  }
}

void ExrRows::finish() {
  State& s = *state_;
  assert(s.next_row == s.header.dataWindow().max.y + 1);
  try {
    s.file.reset();  // writes the table of rows
    s.stream.close();
  } catch (const std::exception& error) {
    throw s.failure(error);
  }
  s.pending.commit();
}

}  // namespace capcon
