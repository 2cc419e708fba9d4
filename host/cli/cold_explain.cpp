#include "cli/cold_explain.h"

#include <cstdlib>

namespace capcon::cli {
namespace {

constexpr const char* kSwitch = "MESA_SHADER_CACHE_DISABLE";

/// Sets the driver's switch unless the user did.
class NoShaderCache {
 public:
  NoShaderCache() : ours_(std::getenv(kSwitch) == nullptr) {
    if (ours_) ::setenv(kSwitch, "true", 1);
  }
  NoShaderCache(const NoShaderCache&) = delete;
  NoShaderCache& operator=(const NoShaderCache&) = delete;
  ~NoShaderCache() {
    if (ours_) ::unsetenv(kSwitch);
  }

 private:
  bool ours_;
};

}  // namespace

Explanation cold_explain(const std::string& scene, int width, int height, const Job& job,
                         const RendererOptions& options, int repeats) {
  const NoShaderCache cold;
  return explain(scene, width, height, job, options, repeats);
}

}  // namespace capcon::cli
