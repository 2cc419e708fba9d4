#pragma once

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace capcon {

/// A whole number that T holds, at least `least`: the library itself would cut any number to size.
/// std::out_of_range for anything else.
template <class T>
T whole(const nlohmann::json& value, T least = 0) {
  const bool natural =
      value.is_number_unsigned() || (value.is_number_integer() && value.get<std::int64_t>() >= 0);
  if (!natural || value.get<std::uint64_t>() > std::numeric_limits<T>::max() || value.get<T>() < least)
    throw std::out_of_range("not a count");
  return value.get<T>();
}
/// The same of an object's member.
template <class T>
T whole(const nlohmann::json& object, const char* name, T least = 0) {
  try {
    return whole<T>(object.at(name), least);
  } catch (const std::out_of_range&) {
    throw std::out_of_range('"' + std::string(name) + "\" is not a count");
  }
}

}  // namespace capcon
