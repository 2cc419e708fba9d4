#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace capcon {

/// A file descriptor that closes itself.
class Descriptor {
 public:
  Descriptor() = default;
  /// As open(2); get() is negative where it failed, errno says why.
  Descriptor(const std::filesystem::path& path, int flags);
  Descriptor(Descriptor&& other) noexcept : fd_(other.fd_) { other.fd_ = -1; }
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor() { close(); }

  int get() const { return fd_; }
  void close();

 private:
  int fd_ = -1;
};

/// Writes all bytes. False where it cannot, errno says why.
bool write_all(int descriptor, std::string_view bytes);

/// Takes the lock of an open file or folder, which goes with the descriptor, whatever ends the process. False
/// where another holds it; a file system without locks gives all of them.
bool lock(int descriptor);

/// Whether `path` still names the file that is open: false where it was removed or replaced since.
bool is_still(int descriptor, const std::filesystem::path& path);

/// Makes the names in a folder last, as fsync does a file's bytes; where a file system cannot, nothing is
/// lost but that.
void flush_folder(const std::filesystem::path& folder);

/// "cannot write FILE: " with the reason of errno and what to do about it. Throws Failure.
[[noreturn]] void fail_to_write(const std::filesystem::path& path);
/// The reason of an error number, and what to do where there is something: "No space left on device; make
/// room, …".
std::string reason_of(int error);

}  // namespace capcon
