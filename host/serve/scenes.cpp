#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "base/file.h"
#include "serve/server.h"

namespace capcon::serve {
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> pbrt_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, ignored))
    if (entry.path().extension() == ".pbrt")
      files.push_back(folder.empty() ? entry.path().filename() : entry.path());
  std::sort(files.begin(), files.end());
  if (files.size() > 100) files.resize(100);
  return files;
}

}  // namespace

std::vector<OfferedScene> offered_scenes(const std::string& given) {
  std::vector<OfferedScene> offered;
  const auto offer = [&](const fs::path& file) {
    for (const OfferedScene& other : offered) {
      std::error_code ignored;
      if (fs::equivalent(other.file, file, ignored)) return;
    }
    std::string name = file.stem().string();
    const auto taken = [&](const OfferedScene& o) { return o.name == name; };
    if (std::any_of(offered.begin(), offered.end(), taken)) name = file.string();
    offered.push_back({name, file.string()});
  };
  if (!given.empty()) {
    if (!fs::is_regular_file(given)) throw InputError("there is no scene " + given);
    offer(given);
    for (const fs::path& file : pbrt_files(fs::path(given).parent_path())) offer(file);
  }
  const fs::path folder = shipped_file("scenes");
  offer(folder / "courtyard.pbrt");
  for (const fs::path& file : pbrt_files(folder)) offer(file);
  return offered;
}

}  // namespace capcon::serve
