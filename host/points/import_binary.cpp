#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>

#include "base/error.h"
#include "base/file.h"
#include "points/import_points.h"

namespace capcon {

namespace {

static_assert(std::endian::native == std::endian::little, "the file is read as it lies in memory");

template <class Number>
std::vector<Points> read_sets(std::string_view data, std::uint32_t sets, std::uint32_t count,
                              const std::string& name) {
  std::vector<Points> result(sets, Points(count));
  const char* at = data.data();
  for (std::uint32_t s = 0; s < sets; ++s) {
    for (std::uint32_t i = 0; i < count; ++i) {
      std::array<Number, 2> p;
      std::memcpy(p.data(), at, sizeof p);
      at += sizeof p;
      for (int axis = 0; axis < 2; ++axis) {
        const auto value = static_cast<double>(p[axis]);
        if (!(value >= 0 && value <= 1)) {
          throw InputError(
              {name, 0, 0},
              fmt::format("set {}, point {}: {} is not in [0, 1]; points live in the unit square", s + 1,
                          i + 1, value));
        }
        result[s][i][axis] = value == 1 ? 0.0 : value + 0.0;
      }
    }
  }
  return result;
}

}  // namespace

std::vector<Points> parse_binary_points(std::string_view bytes, const std::string& name) {
  const auto refuse = [&](const std::string& why) { throw InputError({name, 0, 0}, why); };
  std::array<std::uint32_t, 5> header{};
  if (bytes.size() < sizeof header)
    refuse("is too short for a binary point file of UTK, whose header takes 20 bytes");
  std::memcpy(header.data(), bytes.data(), sizeof header);
  bytes.remove_prefix(sizeof header);
  const auto [magic, type, sets, count, dimensions] = header;
  if (magic != 0x214B5455) refuse("is not a binary point file of UTK: it does not begin with \"UTK!\"");
  const std::uint32_t code = type & 0xff;
  if (code != 4 && code != 5)
    refuse(fmt::format("holds numbers of UTK's type {}; only float (4) and double (5) are read", code));
  if (dimensions != 2) refuse(fmt::format("holds points of {} dimensions; only two are read", dimensions));
  if (sets == 0 || count == 0) refuse("holds no points");
  const std::uint64_t one = code == 4 ? 8 : 16,
                      total = static_cast<std::uint64_t>(sets) * count;  // below 2^64
  if (total > bytes.size() / one || total * one != bytes.size()) {
    refuse(fmt::format("has {} bytes behind its header, not {} sets of {} points of {} bytes", bytes.size(),
                       sets, count, one));
  }
  return code == 4 ? read_sets<float>(bytes, sets, count, name) : read_sets<double>(bytes, sets, count, name);
}

std::vector<Points> import_points(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (ending == ".csv") return parse_csv_points(read_file(path), path.string());
  if (ending == ".bin") return parse_binary_points(read_file(path), path.string());
  return read_points(path);
}

}  // namespace capcon
