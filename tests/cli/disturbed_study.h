#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/process.h"

namespace capcon::testing {

/// A floor, a ball and a wall under a lamp: 8 x 6 pixels, and every kind of study has something to see.
inline std::string tiny_scene(const Folder& folder) {
  return folder.write(
      "tiny.pbrt",
      "LookAt 0 -4 3 0 0 .5 0 0 1\nCamera \"perspective\" \"float fov\" 40\n"
      "Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 6\nWorldBegin\n"
      "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [5 5 4]\nTranslate 0.5 0 2\n"
      "Rotate 180 1 0 0\nShape \"disk\" \"float radius\" 0.6\nAttributeEnd\n"
      "Material \"diffuse\" \"rgb reflectance\" [0.6 0.4 0.3]\n"
      "Shape \"trianglemesh\" \"point3 P\" [-2 -2 0 2 -2 0 2 1 0 -2 1 0 -2 1 2 2 1 2] "
      "\"integer indices\" [0 1 2 0 2 3 3 2 5 3 5 4]\nShape \"sphere\" \"float radius\" 0.5\n");
}

struct StudyKind {
  std::string name, options;
  friend std::ostream& operator<<(std::ostream& out, const StudyKind& kind) { return out << kind.name; }
};

/// Small studies of each kind. The oracle renders them: nothing to compile, so that moments fall into
/// measuring.
inline std::vector<StudyKind> study_kinds() {
  const std::string common =
      " --width 8 --height 6 --seeds 3 --samplers random,sobol-xor,capcon --device reference --quiet "
      "--no-close-ups ";
  return {{"ambient-occlusion", "--radius 2 --samples 1,2,4 --reference-samples 16" + common},
          {"direct", "--samples 1,2,4 --reference-samples 16" + common},
          {"splitting", "--combined 4 --reference-samples 16" + common},
          {"igi", "--sets 1,2 --paths 8 --reference-sets 2" + common}};
}

/// Removes what a clock said, and words about it.
inline void forget_times(nlohmann::json& value) {
  if (value.is_object()) {
    for (auto it = value.begin(); it != value.end();) {
      const std::string& key = it.key();
      const bool timed = key.find("seconds") != std::string::npos || key.find("tim") != std::string::npos;
      if (timed || key == "started" || key == "findings" || key == "command" || key == "explanation" ||
          key == "recommendation") {
        it = value.erase(it);
      } else {
        forget_times(*it++);
      }
    }
  } else if (value.is_array()) {
    for (nlohmann::json& item : value) forget_times(item);
  }
}

/// Everything that a study's folder says, times aside: names, and what must be equal.
inline std::map<std::string, std::string> results_of(const std::string& folder) {
  std::map<std::string, std::string> results;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    const std::string name = std::filesystem::relative(entry.path(), folder).string();
    std::string bytes = contents(entry.path().string());
    if (name == "runs.jsonl") {
      std::istringstream lines(bytes);
      bytes.clear();
      for (std::string line; std::getline(lines, line);) {
        nlohmann::json json = nlohmann::json::parse(line);
        forget_times(json);
        bytes += json.dump() + '\n';
      }
    } else if (name == "study.json") {
      nlohmann::json json = nlohmann::json::parse(bytes);
      forget_times(json);
      bytes = json.dump(1);
    } else if (name == "report.html") {
      bytes = bytes.substr(bytes.size() - std::min<std::size_t>(bytes.size(), 8));  // whole: it has its end
    }
    results[name] = bytes;
  }
  return results;
}

inline void expect_equal_results(const std::string& folder, const std::string& straight) {
  const auto mine = results_of(folder), theirs = results_of(straight);
  std::string names, other_names;
  for (const auto& [name, bytes] : mine) names += name + " ";
  for (const auto& [name, bytes] : theirs) other_names += name + " ";
  ASSERT_EQ(names, other_names);
  for (const auto& [name, bytes] : mine) EXPECT_TRUE(bytes == theirs.at(name)) << name << " differs";
}

/// Files in a folder and below it.
inline std::size_t files_in(const std::string& folder) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    count += !entry.is_directory();
  return count;
}

/// A number in [0, 1) for each i: the moments of a test are the same every time.
inline double moment(std::uint64_t i) {
  std::uint64_t z = (i + 1) * 0x9e3779b97f4a7c15ull;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

}  // namespace capcon::testing
