#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace capcon {

/// For numbers above 0, infinity included: CLI11's own check names the largest double in its message.
inline CLI::Validator positive_number() {
  const auto check = [](const std::string& text) {
    double value = 0;
    return CLI::detail::lexical_cast(text, value) && value > 0 ? std::string()
                                                               : text + " is not a number above 0";
  };
  return {check, "POSITIVE"};
}

}  // namespace capcon
