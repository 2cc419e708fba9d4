// Tile sets and the parts of their splits. Both end in a checksum, which no mutation finds: it is made right.
#include <fmt/format.h>

#include "base/hash.h"
#include "base/little_endian.h"
#include "fuzz/target.h"
#include "sampling/parts_file.h"
#include "tiling/tile_set.h"

namespace capcon::fuzz {
namespace {

void check_tiles(std::string_view bytes) {
  const TileSet set = parse_tile_set(bytes, "f.tiles");
  require(set.tile_count() >= 1, "a set has tiles");
  for (const auto& tile : set.tiles)
    require(tile.empty() || tile.size() == set.points_per_tile, "a tile has all its points");
  require(format_tile_set(set) == bytes, "what was read is written again");
}

void check_permutations(const std::vector<std::vector<std::uint32_t>>& rows) {
  for (const auto& row : rows) {
    std::vector<bool> seen(row.size());
    for (const std::uint32_t number : row) {
      require(number < row.size() && !seen[number], "a row holds every number once");
      seen[number] = true;
    }
  }
}

void check_parts(std::string_view bytes) {
  const PartsFile file = parse_parts(bytes, "f.parts");
  for (const StoredParts& s : file.splits) {
    require(s.parts >= 1 && s.count % s.parts == 0, "parts are equal");
    check_permutations(s.dealt.rank);
    check_permutations(s.dealt.orders);
    for (const auto& order : s.dealt.orders) require(order.size() == s.count, "an order has all points");
  }
  require(format_parts(file) == bytes, "what was read is written again");
}

}  // namespace

void read_tiles(std::string_view bytes) {
  const std::size_t end = bytes.rfind("checksum fnv1a64 ");
  const std::string_view body = bytes.substr(0, end);
  check({"tiles", check_tiles}, fmt::format("{}checksum fnv1a64 {:016x}\n", body, fnv1a64(body)));
  check_tiles(bytes);
}

void read_parts(std::string_view bytes) {
  std::string mended(bytes.substr(0, bytes.size() < 8 ? 0 : bytes.size() - 8));
  put_bytes(mended, fnv1a64(mended));
  check({"parts", check_parts}, mended);
  check_parts(bytes);
}

}  // namespace capcon::fuzz
