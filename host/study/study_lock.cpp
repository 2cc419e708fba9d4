#include "study/study_lock.h"

#include <fcntl.h>
#include <fmt/format.h>

#include "base/error.h"
#include "base/file.h"

namespace capcon {

StudyLock::StudyLock(const std::filesystem::path& folder) {
  create_folder(folder);
  folder_ = Descriptor(folder, O_RDONLY | O_DIRECTORY);
  if (folder_.get() < 0) fail_to_write(folder);
  if (!lock(folder_.get())) {
    throw Failure(fmt::format(
        "{}: another study is running in this folder; wait until it is done, or choose another with -o",
        folder.string()));
  }
}

bool StudyLock::taken(const std::filesystem::path& folder) {
  const Descriptor again(folder, O_RDONLY | O_DIRECTORY);
  return again.get() >= 0 && !lock(again.get());
}

}  // namespace capcon
