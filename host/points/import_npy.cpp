#include <fmt/format.h>

#include <charconv>
#include <vector>

#include "base/error.h"
#include "base/little_endian.h"
#include "points/binary_sets.h"
#include "points/import_points.h"

namespace capcon {
namespace {

constexpr std::string_view kMagic = "\x93NUMPY";

/// What stands behind "'key':" in the header, a Python dictionary as text; empty where the key is missing.
std::string_view value_of(std::string_view header, std::string_view key) {
  for (const char quote : {'\'', '"'}) {
    const std::string wanted = fmt::format("{0}{1}{0}", quote, key);
    std::size_t at = header.find(wanted);
    if (at == header.npos) continue;
    at = header.find_first_not_of(" :", at + wanted.size());
    return at == header.npos ? std::string_view() : header.substr(at);
  }
  return {};
}

/// "(64, 2)" as numbers; empty where it is nothing of that kind.
std::vector<std::uint64_t> shape_of(std::string_view text) {
  std::vector<std::uint64_t> shape;
  if (!text.starts_with('(')) return {};
  text.remove_prefix(1);
  for (;;) {
    const std::size_t begin = text.find_first_not_of(" ,");
    if (begin == text.npos) return {};
    text.remove_prefix(begin);
    if (text.front() == ')') return shape;
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return {};
    shape.push_back(number);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
}

}  // namespace

std::vector<Points> parse_npy_points(std::string_view bytes, const std::string& name) {
  const auto refuse = [&](const std::string& why) { throw InputError({name, 0, 0}, why); };
  if (!bytes.starts_with(kMagic) || bytes.size() < kMagic.size() + 4)
    refuse("is no array of NumPy's: it does not begin with \"\\x93NUMPY\"");
  bytes.remove_prefix(kMagic.size());
  const int version = take_bytes<std::uint8_t>(bytes);
  take_bytes<std::uint8_t>(bytes);
  if (version < 1 || version > 3)
    refuse(fmt::format("is of the format's version {}; 1 to 3 are read", version));
  if (version > 1 && bytes.size() < 4) refuse("ends within its header");
  const std::size_t length =
      version == 1 ? take_bytes<std::uint16_t>(bytes) : take_bytes<std::uint32_t>(bytes);
  if (length > bytes.size()) refuse("ends within its header");
  const std::string_view header = bytes.substr(0, length);
  const std::string_view type = value_of(header, "descr").substr(0, 5);
  const bool doubles = type.find("<f8") != type.npos;
  if (!doubles && type.find("<f4") == type.npos)
    refuse(
        "must hold float32 or float64, little-endian; in Python: numpy.save(file, points.astype(\"<f8\"))");
  if (!value_of(header, "fortran_order").starts_with("False"))
    refuse("is in Fortran's order; in Python: numpy.save(file, numpy.ascontiguousarray(points))");
  const std::vector<std::uint64_t> shape = shape_of(value_of(header, "shape"));
  if (shape.size() < 2 || shape.size() > 3 || shape.back() != 2)
    refuse("must be of shape (points, 2), or (sets, points, 2)");
  const std::uint64_t sets = shape.size() == 3 ? shape[0] : 1;
  return binary_sets(bytes.substr(length), doubles, sets, shape[shape.size() - 2], name);
}

}  // namespace capcon
