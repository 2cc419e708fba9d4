#pragma once

#include <filesystem>
#include <string_view>

namespace capcon::fuzz {

/// A file in memory, for readers that take a path.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view bytes);
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile();

  /// "/proc/self/fd/N"
  std::filesystem::path path() const;

 private:
  int descriptor_;
};

/// Writes bytes to a new file, or over an older one.
void write_plain(const std::filesystem::path& path, std::string_view bytes);

/// A folder of this process's own under $TMPDIR, removed at its end.
const std::filesystem::path& scratch_folder();

}  // namespace capcon::fuzz
