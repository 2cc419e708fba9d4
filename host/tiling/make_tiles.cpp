#include "tiling/make_tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "base/error.h"
#include "base/hash.h"
#include "base/parallel.h"
#include "tiling/farthest_tiles.h"
#include "tiling/region_layout.h"
#include "tiling/tied_optimiser.h"
#include "tiling/tile_ranking.h"

namespace capcon {
namespace {

constexpr std::uint32_t kMaxPointsInSet = 2304;  // ranking's memory grows with the square
constexpr std::uint32_t kTrainingSide = 8;
constexpr std::uint32_t kTilings = 24, kTilingsFor = 16;  // as many tilings for as many tiles
constexpr std::uint64_t kTrainingStream = 0x747261696e;
constexpr double kStride = 1.9;  // over-relaxation of the rounds but the last ones
constexpr double kFlatness = 0.002;
constexpr double kCalmRounds = 0.2;  // this part of the rounds goes without it

// Tilings of few tiles are what renderers use most: their share of the training weight.
struct SmallTilings {
  std::uint32_t a, b, count;
  double share;
};
constexpr SmallTilings kSmall[] = {{1, 0, 8, 0.06}, {1, 1, 16, 0.03}, {2, 0, 32, 0.03}, {2, 2, 16, 0.03}};

std::uint64_t colouring_count(std::uint32_t colours, std::uint32_t vertices) {
  std::uint64_t count = 1;
  for (std::uint32_t v = 0; v < vertices && count < 1000; ++v) count *= colours;
  return count;
}

std::vector<TrainingTiling> training_tilings(const MakeTilesOptions& options, std::uint32_t count) {
  std::vector<TrainingTiling> result;
  const GaussianTiling square(kTrainingSide, 0);
  for (std::uint32_t i = 0; i < count; ++i)
    result.push_back(
        {square,
         random_colours(square, options.colours, options.colouring, mix64(options.seed, kTrainingStream, i)),
         1});
  for (const SmallTilings& small : kSmall) {
    const GaussianTiling tiling(small.a, small.b);
    const std::uint64_t stream = kTrainingStream + 1 + tiling.size();
    // Every colouring if they are few and all allowed, else random ones.
    const std::uint64_t all = colouring_count(options.colours, tiling.size());
    const std::uint64_t used = std::min<std::uint64_t>(all, small.count);
    const double weight = small.share * count * square.size() / double(used * tiling.size());
    for (std::uint64_t i = 0; i < used; ++i) {
      if (options.colouring != Colouring::free) {
        result.push_back(
            {tiling,
             random_colours(tiling, options.colours, options.colouring, mix64(options.seed, stream, i)),
             weight});
        continue;
      }
      std::uint64_t code = all <= small.count ? i : mix64(options.seed, stream, i);
      std::vector<std::uint32_t> colours(tiling.size());
      for (std::uint32_t& c : colours) c = std::uint32_t(code % options.colours), code /= options.colours;
      result.push_back({tiling, std::move(colours), weight});
    }
  }
  return result;
}

// Runs the rounds and returns the last objective.
double optimise(TiedOptimiser& optimiser, std::uint32_t rounds, const std::function<void()>& on_round) {
  double objective = 0;
  for (std::uint32_t r = 0; r < rounds; ++r) {
    objective = optimiser.round(1e-3, r < (1 - kCalmRounds) * rounds ? kStride : 1.0);
    on_round();
  }
  return objective;
}

// Tiles of the set.
std::uint64_t size_of(const MakeTilesOptions& options) {
  constexpr std::uint32_t kMany = 8;  // colours; more are too many anyhow
  return tile_numbers(std::min(options.colours, kMany), options.colouring).size();
}

// Each tile is seen about as often in larger sets as in the one of 16 tiles.
std::uint32_t tilings_of(const MakeTilesOptions& options) {
  if (options.tilings != 0) return options.tilings;
  const auto tiles = std::uint32_t(size_of(options));
  return std::max(kTilings, (kTilings * tiles + kTilingsFor - 1) / kTilingsFor);
}

void check(const MakeTilesOptions& options) {
  if (options.colours < 1 || options.points_per_tile < 1 || options.points_per_tile > kMaxPointsInSet ||
      size_of(options) * options.points_per_tile > kMaxPointsInSet)
    throw InputError(fmt::format(
        "all tiles together may have 1 to {} points: take fewer colours (C of them make C^4 tiles) "
        "or fewer points a tile",
        kMaxPointsInSet));
  if (4 * (std::uint64_t(options.shared_corner) + options.shared_edge) > options.points_per_tile)
    throw InputError("four corners and four edges share more points than a tile has");
  if (options.method == TileMethod::fpo && options.points_per_tile < 4)
    throw InputError("--method fpo needs at least 4 points a tile");
  if (options.starts < 1 || options.rounds < 2 || (options.tilings != 0 && options.tilings < 3))
    throw InputError("at least 1 start, 2 rounds and 3 tilings are needed");
}

}  // namespace

std::string recipe(const MakeTilesOptions& options) {
  const MakeTilesOptions defaults;
  std::string text = fmt::format("capcon tiles make --colours {} --points {} --seed {}", options.colours,
                                 options.points_per_tile, options.seed);
  const auto add = [&](const char* name, auto value, auto usual) {
    if (value != usual) text += fmt::format(" --{} {}", name, value);
  };
  if (options.colouring == Colouring::apart) text += " --compact";
  if (options.method == TileMethod::fpo) text += " --method fpo";
  add("shared-corner", options.shared_corner, defaults.shared_corner);
  add("shared-edge", options.shared_edge, defaults.shared_edge);
  add("starts", options.starts, defaults.starts);
  add("rounds", options.rounds, defaults.rounds);
  add("tilings", options.tilings, defaults.tilings);
  add("moves", options.moves, defaults.moves);
  if (options.flatness) text += fmt::format(" --flatness {}", *options.flatness);
  return text;
}

namespace {

TiedPoints start_points(const MakeTilesOptions& options, std::uint32_t start) {
  const RegionCounts counts{options.shared_corner, options.shared_edge,
                            options.points_per_tile - 4 * (options.shared_corner + options.shared_edge)};
  return random_tied_points(options.colours, options.points_per_tile, counts,
                            mix64(options.seed, kTrainingStream - 1, start), options.colouring);
}

TiedPoints capacity_constrained(const MakeTilesOptions& options) {
  const double flatness = options.flatness.value_or(kFlatness);
  const std::uint32_t tilings = tilings_of(options), few = tilings / 3, start_rounds = options.rounds / 2;
  const double total = double(options.starts) * few * start_rounds + double(tilings) * options.rounds;
  double done = 0;
  std::optional<TiedPoints> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t start = 0; start < options.starts; ++start) {
    TiedOptimiser optimiser(start_points(options, start), training_tilings(options, few), flatness);
    const double objective = optimise(optimiser, start_rounds, [&] {
      done += few;
      if (options.on_round) options.on_round(done / total, optimiser.energy());
    });
    if (objective < least) least = objective, best = optimiser.points();
  }
  TiedOptimiser finish(*best, training_tilings(options, tilings), flatness);
  optimise(finish, options.rounds, [&] {
    done += tilings;
    if (options.on_round) options.on_round(done / total, finish.energy());
  });
  return finish.points();
}

TiedPoints farthest(const MakeTilesOptions& options) {
  std::vector<TiedPoints> all(options.starts);
  parallel_for(options.starts, [&](std::size_t start) {
    FarthestOptions spread;
    spread.rounds = options.rounds;
    spread.flatness = options.flatness.value_or(spread.flatness);
    all[start] = spread_apart(start_points(options, std::uint32_t(start)), spread);
  });
  return *std::ranges::max_element(all, {}, least_distance);
}

}  // namespace

TileSet make_tiles(const MakeTilesOptions& options) {
  check(options);
  const bool is_fpo = options.method == TileMethod::fpo;
  TileSet set = to_tile_set(is_fpo ? farthest(options) : capacity_constrained(options), recipe(options));
  if (const auto fault = find_region_fault(set))
    throw Failure(fmt::format("no good set came out ({}); try another seed or more rounds", fault->message));
  rank_points(set, options.seed, options.moves);
  return set;
}

}  // namespace capcon
