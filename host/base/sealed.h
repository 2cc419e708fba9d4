#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace capcon {

/// Data of a cache with a first line `magic` and checksum (FNV-1a, 64 bits) in front: so that a file which
/// was cut short or damaged is known, whatever is inside.
std::string sealed(std::string_view magic, std::string_view data);

/// What was sealed under this magic; nothing for any other bytes.
std::optional<std::string> unsealed(std::string_view magic, std::string_view bytes);

}  // namespace capcon
