#pragma once

#include <filesystem>

namespace capcon {

/// For programs that are not ours: where shipped_file() looks after $CAPCON_DATA. Empty: nowhere more. The
/// process has one such folder, as it has one environment.
void use_data_folder(const std::filesystem::path& folder);

/// That folder.
std::filesystem::path data_folder();

}  // namespace capcon
