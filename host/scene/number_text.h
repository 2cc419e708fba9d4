#pragma once

#include <string_view>

namespace capcon {

/// What a text says as a number.
enum class NumberText { ok, malformed, not_finite };

/// Reads the whole of `text` as a decimal number ("+1", ".5", "1e-3"). Numbers too small for a double become
/// 0; "nan", "inf" and numbers too large for a double are `not_finite`, everything else that is no number is
/// `malformed`.
NumberText parse_number(std::string_view text, double& value);

}  // namespace capcon
