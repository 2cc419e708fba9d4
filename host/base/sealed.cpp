#include "base/sealed.h"

#include <fmt/format.h>

#include "base/hash.h"

namespace capcon {
namespace {

std::string head(std::string_view magic, std::string_view data) {
  return fmt::format("{} {:016x}\n", magic, fnv1a64(data));
}

}  // namespace

std::string sealed(std::string_view magic, std::string_view data) {
  return head(magic, data).append(data);
}

std::optional<std::string> unsealed(std::string_view magic, std::string_view bytes) {
  const std::size_t length = magic.size() + 18;
  if (bytes.size() < length) return std::nullopt;
  const std::string_view data = bytes.substr(length);
  if (bytes.substr(0, length) != head(magic, data)) return std::nullopt;
  return std::string(data);
}

}  // namespace capcon
