#include "base/cache.h"

#include <cstdlib>

namespace capcon {

std::filesystem::path cache_folder() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  if (cache && *cache) return std::filesystem::path(cache) / "capcon";
  const char* home = std::getenv("HOME");
  if (home && *home) return std::filesystem::path(home) / ".cache" / "capcon";
  return {};
}

}  // namespace capcon
