#include "base/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <system_error>

#include "base/error.h"

namespace capcon {
namespace fs = std::filesystem;

namespace {

std::string reason() { return std::strerror(errno); }

/// A file descriptor that closes itself.
class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags) : fd_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  int get() const { return fd_; }

 private:
  int fd_;
};

[[noreturn]] void fail_to_write(const fs::path& path) {
  throw Failure(fmt::format("cannot write {}: {}", path.string(), reason()));
}

}  // namespace

std::string read_file(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) throw InputError(path.string() + ": is a directory, not a file");
  const Descriptor file(path, O_RDONLY);
  if (file.get() < 0) throw InputError(fmt::format("{}: cannot open: {}", path.string(), reason()));
  std::string bytes;
  const auto size = fs::file_size(path, error);
  if (!error) bytes.reserve(size);
  char block[1 << 16];
  for (;;) {
    const ssize_t got = ::read(file.get(), block, sizeof block);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw InputError(fmt::format("{}: cannot read: {}", path.string(), reason()));
    if (got == 0) return bytes;
    bytes.append(block, static_cast<std::size_t>(got));
  }
}

void write_file(const fs::path& path, std::string_view bytes) {
  PendingFile pending(path);
  {
    const Descriptor file(pending.path(), O_WRONLY | O_CREAT | O_TRUNC);
    if (file.get() < 0) fail_to_write(path);
    while (!bytes.empty()) {
      const ssize_t put = ::write(file.get(), bytes.data(), bytes.size());
      if (put < 0 && errno == EINTR) continue;
      if (put < 0) fail_to_write(path);
      bytes.remove_prefix(static_cast<std::size_t>(put));
    }
  }
  pending.commit();
}

PendingFile::PendingFile(fs::path target) : target_(std::move(target)) {
  temporary_ = target_;
  temporary_ += fmt::format(".{}.partial", ::getpid());
}

PendingFile::~PendingFile() {
  std::error_code ignored;
  if (!committed_) fs::remove(temporary_, ignored);
}

void PendingFile::commit() {
  {
    const Descriptor file(temporary_, O_RDONLY);
    if (file.get() < 0 || ::fsync(file.get()) != 0) fail_to_write(target_);
  }
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail_to_write(target_);
  committed_ = true;
}

void check_writable(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) throw Failure("cannot write " + path.string() + ": it is a directory");
  const PendingFile probe(path);
  const Descriptor file(probe.path(), O_WRONLY | O_CREAT);
  if (file.get() < 0) fail_to_write(path);
}

fs::path shipped_file(const fs::path& relative) {
  std::error_code error;
  std::string tried;
  const auto attempt = [&](const fs::path& root) {
    tried += (tried.empty() ? "" : ", ") + root.string();
    return fs::exists(root / relative, error);
  };
  if (const char* root = std::getenv("CAPCON_DATA"); root && attempt(root)) return fs::path(root) / relative;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share" / "capcon";
  if (!program.empty() && attempt(installed)) return installed / relative;
  if (attempt(CAPCON_SOURCE_DIR)) return fs::path(CAPCON_SOURCE_DIR) / relative;
  throw InputError(fmt::format("{}: this shipped file is not in {}; set CAPCON_DATA to the folder that holds it",
                               relative.string(), tried));
}

std::string_view version() { return CAPCON_VERSION; }

}  // namespace capcon
