// capcon_scenes [--scale N] FOLDER: writes the shipped scenes' geometry into FOLDER.
#include <fmt/format.h>

#include <charconv>
#include <exception>
#include <filesystem>
#include <string_view>

#include "base/error.h"
#include "base/file.h"
#include "base/stop.h"
#include "generator/atelier.h"
#include "generator/courtyard.h"
#include "generator/lights.h"
#include "generator/nave.h"
#include "generator/terrace.h"

namespace {
using namespace capcon;

void write(const scenes::Assembly& scene, const std::filesystem::path& folder) {
  scene.write(folder);
  fmt::print("{}: {} triangles, {} with all instances\n", scene.name(), scene.unique_triangles(),
             scene.instanced_triangles());
}

int run(int argc, char** argv) {
  int scale = 1;
  std::filesystem::path folder;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--scale" && i + 1 < argc) {
      const std::string_view value = argv[++i];
      const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), scale);
      if (error != std::errc() || end != value.data() + value.size() || scale < 1 || scale > 32) {
        throw InputError(fmt::format("--scale {}: give a whole number from 1 to 32", value));
      }
    } else if (folder.empty() && !word.starts_with('-')) {
      folder = word;
    } else {
      folder.clear();
      break;
    }
  }
  if (folder.empty()) throw InputError("usage: capcon_scenes [--scale N] FOLDER");
  create_folder(folder);
  write(scenes::courtyard(scale), folder);
  write(scenes::nave(), folder);
  write(scenes::atelier(), folder);
  write(scenes::terrace(), folder);
  scenes::write_terrace_data(folder);
  scenes::write_lights_data(folder);
  return 0;
}
}  // namespace

int main(int argc, char** argv) {
  capcon::end_on_signals("capcon_scenes");
  try {
    return run(argc, argv);
  } catch (const capcon::InputError& error) {
    fmt::print(stderr, "capcon_scenes: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "capcon_scenes: {}\n", error.what());
    return 1;
  }
}
