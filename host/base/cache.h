#pragma once

#include <filesystem>

namespace capcon {

/// Where a program keeps what it can make again: $XDG_CACHE_HOME/capcon, else $HOME/.cache/capcon; empty when
/// neither is set.
std::filesystem::path cache_folder();

}  // namespace capcon
