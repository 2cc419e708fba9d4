#include "tiling/make_tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "base/error.h"
#include "base/hash.h"
#include "base/parallel.h"
#include "tiling/even_points.h"
#include "tiling/farthest_tiles.h"
#include "tiling/region_layout.h"
#include "tiling/tied_optimiser.h"
#include "tiling/tile_ranking.h"
#include "tiling/training_tilings.h"

namespace capcon {
namespace {

constexpr std::uint32_t kMaxPointsInSet = 2304;           // ranking's memory grows with the square
constexpr std::uint32_t kTilings = 24, kTilingsFor = 16;  // as many tilings for as many tiles
constexpr std::uint64_t kStartStream = 0x747261696d;
constexpr double kStride = 1.9;                             // over-relaxation of the rounds but the last ones
constexpr double kEvenStride = 2.5, kEvenStrideFall = 1.5;  // of bounded sets: down to 1
constexpr std::uint32_t kRoundsInCells = 30;
constexpr double kLoose = 0.5, kSettled = 0.9;  // parts of the rounds: make_even's `settled` goes from 0 to 1
constexpr double kFlatness = 0.002, kEvenFlatness = 0.0012;
constexpr double kCalmRounds = 0.2;  // this part of the rounds goes without it

double stride_of(std::uint32_t round, std::uint32_t rounds) {
  return round < (1 - kCalmRounds) * rounds ? kStride : 1.0;
}

// Points that go into cells of their own stop early; strides that are too far shake them on to better cells.
double stride_of_even(std::uint32_t round, std::uint32_t rounds) {
  return std::max(1.0, kEvenStride - kEvenStrideFall * round / rounds);
}

double settled(std::uint32_t round, std::uint32_t rounds) {
  return std::clamp((double(round) / rounds - kLoose) / (kSettled - kLoose), 0.0, 1.0);
}

// Runs the rounds and returns the last objective. `even`: points of bounded sets go into cells of their own
// after each.
double optimise(TiedOptimiser& optimiser, std::uint32_t rounds, bool even,
                const std::function<void()>& on_round) {
  double objective = 0;
  for (std::uint32_t r = 0; r < rounds; ++r) {
    objective = optimiser.round(1e-3, even ? stride_of_even(r, rounds) : stride_of(r, rounds));
    if (even) {
      TiedPoints points = optimiser.points();
      make_even(points, settled(r, rounds));
      optimiser.set_points(std::move(points));
    }
    on_round();
  }
  return objective;
}

// The cells stay, and with them what random places in them do; their points go where the energy is least.
void move_in_cells(TiedOptimiser& optimiser) {
  for (std::uint32_t r = 0; r < kRoundsInCells; ++r) {
    const TiedPoints before = optimiser.points();
    optimiser.round();
    TiedPoints points = optimiser.points();
    keep_in_cells(points, before);
    optimiser.set_points(std::move(points));
  }
}

bool is_bounded(const MakeTilesOptions& options) {
  return options.colouring == Colouring::bounded;
}

// With the one for outside.
std::uint32_t all_colours(const MakeTilesOptions& options) {
  return options.colours + (is_bounded(options) ? 1 : 0);
}

// Tiles of the set.
std::uint64_t size_of(const MakeTilesOptions& options) {
  constexpr std::uint32_t kMany = 8;  // colours; more are too many anyhow
  return tile_numbers(std::min(all_colours(options), kMany), options.colouring).size();
}

// Each tile is seen about as often in larger sets as in the one of 16 tiles.
std::uint32_t tilings_of(const MakeTilesOptions& options) {
  if (options.tilings != 0) return options.tilings;
  if (is_bounded(options)) return kTilings;
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
  if (!is_bounded(options)) return;
  if (options.method == TileMethod::fpo || options.shared_corner > 0 || options.shared_edge > 0)
    throw InputError(
        "--boundary goes without --method fpo, --shared-corner and --shared-edge: a bounded set's points are "
        "capacity-constrained, and each is of one tile");
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
  if (is_bounded(options)) text += " --boundary";
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
  return random_tied_points(all_colours(options), options.points_per_tile, counts,
                            mix64(options.seed, kStartStream, start), options.colouring);
}

TiedPoints capacity_constrained(const MakeTilesOptions& options) {
  const bool even = is_bounded(options);
  const double flatness = options.flatness.value_or(even ? kEvenFlatness : kFlatness);
  const TrainingSet training{all_colours(options), options.colouring, options.seed};
  const std::uint32_t tilings = tilings_of(options), few = tilings / 3, start_rounds = options.rounds / 2;
  const double total = double(options.starts) * few * start_rounds + double(tilings) * options.rounds;
  double done = 0;
  std::optional<TiedPoints> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t start = 0; start < options.starts; ++start) {
    TiedOptimiser optimiser(start_points(options, start), training_tilings(training, few), flatness);
    const double objective = optimise(optimiser, start_rounds, even, [&] {
      done += few;
      if (options.on_round) options.on_round(done / total, optimiser.energy());
    });
    if (objective < least) least = objective, best = optimiser.points();
  }
  TiedOptimiser finish(*best, training_tilings(training, tilings), flatness);
  optimise(finish, options.rounds, even, [&] {
    done += tilings;
    if (options.on_round) options.on_round(done / total, finish.energy());
  });
  if (even) move_in_cells(finish);
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
