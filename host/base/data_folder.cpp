#include "base/data_folder.h"

#include <mutex>

namespace capcon {
namespace {

std::mutex mutex;
std::filesystem::path& folder_in_use() {
  static std::filesystem::path folder;
  return folder;
}

}  // namespace

void use_data_folder(const std::filesystem::path& folder) {
  const std::lock_guard guard(mutex);
  folder_in_use() = folder;
}

std::filesystem::path data_folder() {
  const std::lock_guard guard(mutex);
  return folder_in_use();
}

}  // namespace capcon
