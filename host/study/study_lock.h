#pragma once

#include <filesystem>

#include "base/descriptor.h"

namespace capcon {

/// One study at a time in a folder: two would write over each other's runs. The lock is the folder's own and
/// goes with the process, however it ends, so none is ever left behind.
class StudyLock {
 public:
  /// Creates the folder where it is not there. Failure where another process has the lock, or there can be no
  /// folder.
  explicit StudyLock(const std::filesystem::path& folder);
  /// Whether somebody has the lock now, this process included. False where a file system has no locks.
  static bool taken(const std::filesystem::path& folder);

 private:
  Descriptor folder_;
};

}  // namespace capcon
