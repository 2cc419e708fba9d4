#include "capcon/tile_set.h"

#include <fmt/format.h>

#include "base/data_folder.h"
#include "base/error.h"
#include "base/file.h"
#include "tiling/tiling.h"

namespace capcon::sampling {

namespace {

constexpr std::uint32_t kWidest = 256;

std::filesystem::path path_of(const std::string& file) {
  const bool shipped = file.find_first_of("./") == std::string::npos;
  return shipped ? shipped_file("tiles/" + file + ".tiles") : std::filesystem::path(file);
}

}  // namespace

struct TileSet::State {
  capcon::TileSet set;
};

TileSet::TileSet(const std::string& file, const std::string& data) {
  use_data_folder(data);
  state_ = std::make_unique<State>(State{read_tile_set(path_of(file))});
}

TileSet::TileSet(TileSet&&) noexcept = default;
TileSet& TileSet::operator=(TileSet&&) noexcept = default;
TileSet::~TileSet() = default;

std::uint32_t TileSet::colours() const {
  return state_->set.colours;
}

std::uint32_t TileSet::points_per_tile() const {
  return state_->set.points_per_tile;
}

std::uint32_t TileSet::tiles() const {
  return static_cast<std::uint32_t>(state_->set.tiles.size());
}

std::uint32_t TileSet::tile(std::uint32_t c00, std::uint32_t c10, std::uint32_t c01,
                            std::uint32_t c11) const {
  const std::uint32_t base = colours();
  for (const std::uint32_t colour : {c00, c10, c01, c11}) {
    if (colour >= base) throw InputError(fmt::format("colour {}: this set has {}", colour, base));
  }
  return c00 + base * (c10 + base * (c01 + base * c11));
}

std::vector<Point> TileSet::points(std::uint32_t tile) const {
  if (tile >= tiles()) throw InputError(fmt::format("tile {}: this set has {}", tile, tiles()));
  std::vector<Point> points;
  for (const auto& point : state_->set.tiles[tile]) {
    const auto p = to_double(point.position);
    points.push_back({p.x, p.y});
  }
  return points;
}

std::vector<Point> TileSet::tiling(std::uint32_t side, std::uint64_t seed, std::uint32_t ranks) const {
  const capcon::TileSet& set = state_->set;
  if (side == 0 || side > kWidest)
    throw InputError(fmt::format("a tiling of {0} x {0} tiles: its side must be 1 to {1}", side, kWidest));
  if (ranks > set.points_per_tile)
    throw InputError(fmt::format("{} ranks: a tile of this set has {}", ranks, set.points_per_tile));
  const GaussianTiling tiling(side, 0);
  std::vector<Point> points;
  for (const auto& p :
       tile_points(set, tiling, random_colours(tiling, set, seed), ranks == 0 ? set.points_per_tile : ranks))
    points.push_back({p.x, p.y});
  return points;
}

}  // namespace capcon::sampling
