#include "base/error.h"

#include <fmt/format.h>

namespace capcon {

std::string SourcePlace::str() const {
  if (file.empty() || line <= 0) return file;
  return column > 0 ? fmt::format("{}:{}:{}", file, line, column) : fmt::format("{}:{}", file, line);
}

std::string one_line(const std::string& text) {
  constexpr std::size_t kLongest = 900, kHalf = 440;
  std::string line;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte != 0x7f) {
      line += c;
    } else {
      line += c == '\n' ? "\\n" : fmt::format("\\x{:02x}", byte);
    }
  }
  if (line.size() <= kLongest) return line;
  return line.substr(0, kHalf) + " ... " + line.substr(line.size() - kHalf);
}

InputError::InputError(const SourcePlace& place, const std::string& message)
    : InputError(place.file.empty() ? message : place.str() + ": " + message) {}

}  // namespace capcon
