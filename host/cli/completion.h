#pragma once

#include <string>

#include "cli/command_table.h"

namespace capcon::cli {

// Scripts that complete verbs, options and the values that can be named; else names of files.

std::string bash_completion(const CommandRow& program);
std::string zsh_completion(const CommandRow& program);
std::string fish_completion(const CommandRow& program);

}  // namespace capcon::cli
