#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace capcon {

/// `; did you mean "Shape"?` for the known name nearest to `name` by edit distance, or nothing when none is
/// near.
std::string suggestion(std::string_view name, const std::vector<std::string_view>& known);

}  // namespace capcon
