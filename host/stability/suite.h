#pragma once

#include <functional>
#include <string>
#include <vector>

#include "stability/check.h"

namespace capcon::stability {

struct SuiteOptions {
  std::string device = "best";
  std::string folder;             ///< where scenes are written
  bool brief = false;             ///< a case of each kind, fewer rays and samples: for CI
  std::vector<std::string> only;  ///< names or groups; empty: all
};

/// Names and groups of all checks, in order: (group, name).
std::vector<std::pair<std::string, std::string>> names_of_checks(const SuiteOptions& options);
/// Runs the checks one after another; `on_check` is called after each with the number of all. What throws
/// becomes a check that failed, with the sentence. InputError where
/// `only` names nothing; InputError and Failure where the device is not there.
std::vector<Check> run_suite(const SuiteOptions& options,
                             const std::function<void(const Check&, std::size_t all)>& on_check);

}  // namespace capcon::stability
