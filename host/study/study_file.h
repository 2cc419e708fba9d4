#pragma once

#include <filesystem>
#include <optional>

#include "render/explain.h"
#include "study/runner.h"

namespace capcon {

/// A study.json of this version of the program or an older one, as far as it is read again: runs lie in
/// runs.jsonl, and the reference's image in a file of its own.
struct StudyFile {
  StudyResult result;
  std::optional<Explanation> explanation;
};

/// InputError where it is none, or says what no study says.
StudyFile read_study_file(const std::filesystem::path& file);

}  // namespace capcon
