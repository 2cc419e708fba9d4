#include "scene/number_text.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>

namespace capcon {

NumberText parse_number(std::string_view text, double& value) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc::invalid_argument || stop != end) return NumberText::malformed;
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(text).c_str(), nullptr);
  return std::isfinite(value) ? NumberText::ok : NumberText::not_finite;
}

}  // namespace capcon
