#include "base/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

#include "base/data_folder.h"
#include "base/error.h"
#include "base/stop.h"

namespace capcon {
namespace fs = std::filesystem;

namespace {

/// A pipe, a terminal, a device: nothing that could be renamed. Standard output is one whatever it leads to:
/// its file is the shell's.
bool is_stream(const fs::path& path) {
  const std::string name = path.lexically_normal().string();
  for (const char* stream : {"/dev/stdout", "/dev/stderr", "/dev/fd/", "/proc/self/fd/"})
    if (name.starts_with(stream)) return true;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void refuse_folder(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error))
    throw Failure("cannot write " + path.string() + ": it is a directory; name a file in it");
}

/// Where a link leads to, so that the link stays.
fs::path behind_links(const fs::path& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  const fs::path real = fs::weakly_canonical(path, error);
  return error ? path : real;
}

}  // namespace

std::string read_file(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) throw InputError(path.string() + ": is a directory, not a file");
  const Descriptor file(path, O_RDONLY);
  if (file.get() < 0)
    throw InputError(fmt::format("{}: cannot open: {}", path.string(), std::strerror(errno)));
  std::string bytes;
  const auto size = fs::file_size(path, error);
  if (!error) bytes.reserve(size);
  char block[1 << 16];
  for (;;) {
    const ssize_t got = ::read(file.get(), block, sizeof block);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw InputError(fmt::format("{}: cannot read: {}", path.string(), std::strerror(errno)));
    if (got == 0) return bytes;
    bytes.append(block, static_cast<std::size_t>(got));
  }
}

void write_file(const fs::path& path, std::string_view bytes) {
  if (is_stream(path)) {
    const Descriptor stream(path, O_WRONLY | O_APPEND);
    if (stream.get() < 0 || !write_all(stream.get(), bytes)) fail_to_write(path);
    return;
  }
  PendingFile pending(path);
  if (!write_all(pending.descriptor(), bytes)) fail_to_write(path);
  pending.commit();
}

PendingFile::PendingFile(const fs::path& target) : target_(behind_links(target)) {
  refuse_folder(target);
  constexpr int kMostWriters = 100;
  for (int writer = 1; writer <= kMostWriters; ++writer) {
    fs::path name = target_;
    name += writer == 1 ? ".writing" : fmt::format(".{}.writing", writer);
    if (take(name)) return;
  }
  throw Failure(fmt::format("cannot write {}: too many programs are writing it", target.string()));
}

/// False where another writes to a temporary file of this name.
bool PendingFile::take(const fs::path& name) {
  for (;;) {
    const StopLater to_register;
    Descriptor file(name, O_RDWR | O_CREAT | O_NOFOLLOW);
    if (file.get() < 0) {
      std::error_code error;
      const int reason = errno;
      if (reason == EACCES && fs::exists(name, error)) return false;  // another user's
      errno = reason;
      fail_to_write(target_);
    }
    if (!lock(file.get())) return false;
    if (!is_still(file.get(), name)) continue;  // its writer was just done
    // What was there is of a writer that was killed.
    if (::ftruncate(file.get(), 0) != 0) fail_to_write(target_);
    file_ = std::move(file);
    temporary_ = name;
    register_temporary(temporary_);
    return true;
  }
}

PendingFile::~PendingFile() {
  if (committed_) return;
  const StopLater to_forget;
  if (is_still(file_.get(), temporary_)) ::unlink(temporary_.c_str());
  forget_temporary(temporary_);
}

void PendingFile::commit() {
  if (::fsync(file_.get()) != 0 && errno != EINVAL)
    fail_to_write(target_);  // EINVAL: cannot be flushed, as in /proc
  {
    const StopLater to_forget;
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail_to_write(target_);
    committed_ = true;
    forget_temporary(temporary_);
  }
  flush_folder(target_.parent_path());
}

void check_writable(const fs::path& path) {
  if (is_stream(path)) {
    if (::access(path.c_str(), W_OK) != 0) fail_to_write(path);
  } else {
    const PendingFile probe(path);
  }
}

void create_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw Failure(fmt::format("cannot create the folder {}: {}", folder.string(), reason_of(error.value())));
}

fs::path shipped_file(const fs::path& relative) {
  std::error_code error;
  std::string tried;
  const auto attempt = [&](const fs::path& root) {
    tried += (tried.empty() ? "" : ", ") + root.string();
    return fs::exists(root / relative, error);
  };
  if (const char* root = std::getenv("CAPCON_DATA"); root && attempt(root)) return fs::path(root) / relative;
  if (const fs::path named = data_folder(); !named.empty() && attempt(named)) return named / relative;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share" / "capcon";
  if (!program.empty() && attempt(installed)) return installed / relative;
  if (attempt(CAPCON_SOURCE_DIR)) return fs::path(CAPCON_SOURCE_DIR) / relative;
  throw InputError(
      fmt::format("{}: this shipped file is not in {}; set CAPCON_DATA to the folder that holds it",
                  relative.string(), tried));
}

std::string_view version() {
  return CAPCON_VERSION;
}

}  // namespace capcon
