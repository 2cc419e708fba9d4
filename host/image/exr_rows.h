#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "image/image.h"

namespace capcon {

/// Writes an EXR row by row, for images that need not be in memory as a whole: 32-bit float, ZIP, channels as
/// write_exr(). The file appears, complete, at finish(); before that there is only a temporary one beside it.
class ExrRows {
 public:
  /// `channels` 1 or 3. Failure when the file cannot be written.
  ExrRows(const std::filesystem::path& path, int width, int height, int channels,
          const Attributes& attributes);
  ~ExrRows();

  /// The next rows from the top: a multiple of width * channels values.
  void write(std::span<const float> pixels);
  /// After the last row. Failure when the disk is full.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace capcon
