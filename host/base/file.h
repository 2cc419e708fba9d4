#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/descriptor.h"

namespace capcon {

/// The whole file as bytes. InputError when it is missing, a directory or unreadable.
std::string read_file(const std::filesystem::path& path);

/// Writes a file completely or not at all: the bytes go to a temporary file beside it, which is flushed to
/// disk and renamed over `path`; a link is followed. Failure (with the system's reason and what to do) leaves
/// nothing behind and an older file untouched. What is no file (a pipe, /dev/stdout, a terminal) is written
/// straight.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// The same promise for writers that need a file name of their own (OpenEXR): write to `path()`, then
/// `commit()`. Without commit the temporary file is removed, also where a signal ends the program
/// (base/stop.h).
///
/// The temporary file is "TARGET.writing" ("TARGET.2.writing" while another process writes the same target),
/// and locked as long as it is written: what kill -9 leaves is not locked, and taken over by the next who
/// writes the target.
class PendingFile {
 public:
  /// Failure where there can be no such file.
  explicit PendingFile(const std::filesystem::path& target);
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile();

  const std::filesystem::path& path() const { return temporary_; }
  /// The open, empty file.
  int descriptor() const { return file_.get(); }
  /// Flushes to disk and renames to the target. Failure when the disk is full or the target cannot be
  /// replaced.
  void commit();

 private:
  bool take(const std::filesystem::path& name);

  std::filesystem::path target_;
  std::filesystem::path temporary_;
  Descriptor file_;
  bool committed_ = false;
};

/// Fails early (Failure) when a file of this name could not be written: so that no long work is lost.
void check_writable(const std::filesystem::path& path);

/// Makes a folder and those above it. Failure when it cannot be.
void create_folder(const std::filesystem::path& folder);

/// A shipped file or folder ("tiles/c2n16.tiles", "scenes/courtyard.pbrt"): under $CAPCON_DATA, beside the
/// program as installed, or in the source tree that built it, whichever exists first. InputError when there
/// is none.
std::filesystem::path shipped_file(const std::filesystem::path& relative);

/// "0.1.0"
std::string_view version();

}  // namespace capcon
