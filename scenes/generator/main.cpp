// capcon_scenes [--scale N] FOLDER: writes the shipped scenes' geometry into FOLDER.
#include <fmt/format.h>

#include <charconv>
#include <exception>
#include <filesystem>
#include <string_view>

#include "base/error.h"
#include "generator/courtyard.h"

namespace {
using namespace capcon;

void report(const scenes::Assembly& scene, const char* name) {
  fmt::print("{}: {} triangles, {} with all instances\n", name, scene.unique_triangles(),
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
  std::filesystem::create_directories(folder);
  const scenes::Assembly court = scenes::courtyard(scale);
  court.write(folder);
  report(court, "courtyard");
  return 0;
}
}  // namespace

int main(int argc, char** argv) {
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
