#include "sampling/parts_store.h"

#include <algorithm>
#include <filesystem>

#include "base/file.h"
#include "base/parallel.h"
#include "sampling/parts_file.h"

namespace capcon {
namespace {

constexpr std::uint32_t kFewestPoints = 16;

/// Whether the numbers are those of this tiling: sizes; the file's reader has checked the rest.
bool fits(const TilingParts& dealt, const TileSet& set, const GaussianTiling& tiling,
          const CellPoints& points) {
  if (has_whole_tilings(tiling))
    return dealt.rank.empty() && dealt.orders.size() == std::size_t(1) << tiling.size();
  return dealt.rank.size() == set.tiles.size() && dealt.orders.size() == 1 &&
         dealt.rank[0].size() == points.most();
}

}  // namespace

TilingParts shipped_or_made_parts(const TileSet& set, const GaussianTiling& tiling, const CellPoints& points,
                                  std::uint32_t parts) {
  const std::uint32_t count = points.count();
  const auto splits = shipped_splits();
  if (std::ranges::find(splits, std::pair(count, parts)) != splits.end()) {
    // Beside the tile set, not wherever one is found first: a set of the user's own comes with its own parts.
    const std::filesystem::path path = shipped_file("tiles/c2n16.tiles").replace_extension(".parts");
    std::error_code error;
    if (std::filesystem::exists(path, error)) {
      PartsFile file = parse_parts(read_file(path), path.string());
      if (file.tiles != checksum(set)) file.splits.clear();
      for (StoredParts& s : file.splits)
        if (s.count == count && s.parts == parts && fits(s.dealt, set, tiling, points))
          return std::move(s.dealt);
    }
  }
  return make_tiling_parts(set, tiling, points, parts);
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> shipped_splits() {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> splits;
  for (std::uint32_t count = kFewestPoints; count <= kMostStoredPoints; count *= 2)
    for (std::uint32_t parts = 2; parts <= count; parts *= 2) splits.emplace_back(count, parts);
  return splits;
}

std::string make_shipped_parts(const TileSet& set) {
  const auto splits = shipped_splits();
  PartsFile file{checksum(set), std::vector<StoredParts>(splits.size())};
  parallel_for(splits.size(), [&](std::size_t i) {
    const auto [count, parts] = splits[i];
    const TilingCut cut = choose_cut(count, set.points_per_tile);
    const GaussianTiling tiling(cut.a, cut.b);
    file.splits[i] = {count, parts, make_tiling_parts(set, tiling, cell_points(cut, tiling), parts)};
  });
  return format_parts(file);
}

}  // namespace capcon
