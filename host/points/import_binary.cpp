#include <fmt/format.h>

#include <array>
#include <cstring>

#include "base/error.h"
#include "base/file.h"
#include "points/binary_sets.h"
#include "points/import_points.h"

namespace capcon {

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
  return binary_sets(bytes, code == 5, sets, count, name);
}

std::vector<Points> import_points(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (ending == ".csv") return parse_csv_points(read_file(path), path.string());
  if (ending == ".bin") return parse_binary_points(read_file(path), path.string());
  if (ending == ".npy") return parse_npy_points(read_file(path), path.string());
  return read_points(path);
}

}  // namespace capcon
