#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "render/explain.h"
#include "study/close_ups.h"
#include "study/figures.h"
#include "study/runner.h"

namespace capcon {

/// A finished study as it lies in its folder, of this version of the program or an older one.
struct KeptStudy {
  std::filesystem::path folder;
  std::string hash;    ///< of its settings: what its images must have been made with
  StudyResult result;  ///< the reference's image is empty where reference.exr is not there
  std::optional<Explanation> explanation;
};

/// Reads study.json, runs.jsonl and, if it is there, reference.exr. InputError where there is no finished
/// study.
KeptStudy read_kept_study(const std::filesystem::path& folder);

/// Its figures, with those of the images of its runs where these are there.
Figures make_figures(const KeptStudy& study);

/// Its page, with what is there: no device is needed.
std::string html_report(const KeptStudy& study, const Figures& figures);

}  // namespace capcon
