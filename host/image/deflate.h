#pragma once

#include <string>
#include <string_view>

namespace capcon {

/// In zlib's format (RFC 1950).
std::string deflated(std::string_view bytes);

}  // namespace capcon
