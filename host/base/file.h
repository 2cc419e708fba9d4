#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace capcon {

/// The whole file as bytes. InputError when it is missing, a directory or unreadable.
std::string read_file(const std::filesystem::path& path);

/// Writes a file completely or not at all: the bytes go to a temporary file beside it, which is flushed to disk and
/// renamed over `path`. Failure (with the system's reason) leaves nothing behind and an older file untouched.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// The same promise for writers that need a file name of their own (OpenEXR): write to `path()`, then `commit()`.
/// Without commit the temporary file is removed.
class PendingFile {
 public:
  explicit PendingFile(std::filesystem::path target);
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile();

  const std::filesystem::path& path() const { return temporary_; }
  /// Flushes to disk and renames to the target. Failure when the disk is full or the target cannot be replaced.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  bool committed_ = false;
};

/// Fails early (Failure) when a file of this name could not be written: so that no long work is lost.
void check_writable(const std::filesystem::path& path);

/// A shipped file or folder ("tiles/c2n16.tiles", "scenes/courtyard.pbrt"): under $CAPCON_DATA, beside the program as
/// installed, or in the source tree that built it, whichever exists first. InputError when there is none.
std::filesystem::path shipped_file(const std::filesystem::path& relative);

/// "0.1.0"
std::string_view version();

}  // namespace capcon
