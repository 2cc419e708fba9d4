#include "base/error.h"

#include <fmt/format.h>

namespace capcon {

std::string SourcePlace::str() const {
  if (file.empty() || line <= 0) return file;
  return column > 0 ? fmt::format("{}:{}:{}", file, line, column) : fmt::format("{}:{}", file, line);
}

InputError::InputError(const SourcePlace& place, const std::string& message)
    : std::runtime_error(place.file.empty() ? message : place.str() + ": " + message) {}

}  // namespace capcon
