#pragma once

#include <string>

#include "cli/command_table.h"

namespace capcon::cli {

/// The manual page, section 1, in man(7)'s macros.
std::string man_page(const CommandRow& program);

}  // namespace capcon::cli
