#include "tiling/tile_ranking.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "base/hash.h"
#include "base/parallel.h"
#include "tiling/tile_pairs.h"

namespace capcon {
namespace {

constexpr double kReach = 1.6;  // of the potential, in spacings of the hexagonal lattice
// Prefixes of a quarter of the points or more choose among points that keep a distance already; what is left
// to gain is the nearest neighbour's distance, hence a shorter reach. The hardest is half of the points.
constexpr double kLongReach = 1.3, kLongWeight = 2.5;
constexpr double kOneTileWeight =
    4;  // of the one-tile tilings, in parts of the infinite tiling's weight: few samples use them
constexpr double kSmallPower = 3;  // powers of two count this much more than other short prefixes
constexpr std::uint32_t kAllRanks = 16, kStep = 4;  // prefixes up to here all count, then every kStep-th
constexpr double kHeat = 1.5;                       // first temperature, in potential of one point
constexpr std::uint64_t kRankStream = 0x72616e6b;

bool is_long(std::uint32_t rank, std::uint32_t nt) {
  return 4 * rank >= nt;
}

// Both potentials of every pair of points of the set (of i at j and of j at i), for one prefix length.
class Potential {
 public:
  Potential(const TileSet& set, std::uint32_t rank, TilePairs& pairs)
      : nt_(set.points_per_tile),
        tiles_(std::uint32_t(set.tile_count())),
        numbers_(tile_numbers(set)),
        q_(std::size_t(nt_) * nt_ * tiles_ * tiles_) {
    const double spacings = is_long(rank, nt_) ? kLongReach : kReach;
    const double reach2 = spacings * spacings * 2 / (std::sqrt(3.0) * rank);
    const int far = int(std::ceil(std::sqrt(reach2)));
    for (int dy = -far; dy <= far; ++dy)
      for (int dx = -far; dx <= far; ++dx) add(set, {dx, dy}, pairs.at(dx, dy), reach2);
  }
  double operator()(std::size_t i, std::size_t j) const { return q_[i * nt_ * tiles_ + j]; }

 private:
  void add(const TileSet& set, glm::dvec2 shift, const std::vector<double>& weights, double reach2) {
    for (std::uint32_t t = 0; t < tiles_; ++t)
      for (std::uint32_t u = 0; u < tiles_; ++u) {
        if (weights[t * tiles_ + u] == 0) continue;
        for (std::uint32_t i = 0; i < nt_; ++i)
          for (std::uint32_t j = 0; j < nt_; ++j) {
            const glm::dvec2 d = to_double(set.tiles[numbers_[u]][j].position) + shift -
                                 to_double(set.tiles[numbers_[t]][i].position);
            const double s = 1 - glm::dot(d, d) / reach2;
            if (s <= 0 || (t == u && i == j && shift == glm::dvec2(0))) continue;
            q_[(std::size_t(t) * nt_ + i) * nt_ * tiles_ + u * nt_ + j] +=
                weights[t * tiles_ + u] * s * s * s * s;
          }
      }
  }
  std::uint32_t nt_, tiles_;
  std::vector<std::uint32_t> numbers_;
  std::vector<float> q_;
};

// The lengths of prefixes that count.
std::vector<std::uint32_t> prefix_lengths(std::uint32_t nt) {
  std::vector<std::uint32_t> lengths;
  for (std::uint32_t r = 1; r < nt; r += r < kAllRanks ? 1 : kStep) lengths.push_back(r);
  return lengths;
}

// The state of the annealing: who has which rank, and every point's potential in every prefix.
class Ranking {
 public:
  explicit Ranking(const TileSet& set)
      : nt_(set.points_per_tile), points_(set.tile_count() * nt_), lengths_(prefix_lengths(nt_)) {
    TilePairs pairs(set, kOneTileWeight);
    for (const std::uint32_t r : lengths_) potentials_.emplace_back(set, r, pairs);
    order_.resize(points_);
    for (std::size_t i = 0; i < points_; ++i) order_[i] = std::uint32_t(i);
    fields_.assign(lengths_.size(), std::vector<double>(points_));
    for (std::size_t p = 0; p < lengths_.size(); ++p)
      for (std::size_t i = 0; i < points_; ++i)
        if (i % nt_ < lengths_[p])
          for (std::size_t k = 0; k < points_; ++k) fields_[p][k] += both(p, i, k);
  }
  // By how much the objective changes when the points of ranks a < b of a tile change places.
  double change(std::size_t tile, std::uint32_t a, std::uint32_t b) const {
    const std::size_t out = order_[tile * nt_ + a], in = order_[tile * nt_ + b];
    double sum = 0;
    for (std::size_t p = 0; p < lengths_.size(); ++p)
      if (a < lengths_[p] && lengths_[p] <= b)
        sum += weight(lengths_[p]) * (fields_[p][in] - fields_[p][out] - both(p, in, out) +
                                      0.5 * (both(p, in, in) + both(p, out, out)));
    return sum;
  }
  void swap(std::size_t tile, std::uint32_t a, std::uint32_t b) {
    const std::size_t out = order_[tile * nt_ + a], in = order_[tile * nt_ + b];
    for (std::size_t p = 0; p < lengths_.size(); ++p)
      if (a < lengths_[p] && lengths_[p] <= b)
        for (std::size_t k = 0; k < points_; ++k) fields_[p][k] += both(p, in, k) - both(p, out, k);
    std::swap(order_[tile * nt_ + a], order_[tile * nt_ + b]);
  }
  std::uint32_t at(std::size_t tile, std::uint32_t rank) const { return order_[tile * nt_ + rank] % nt_; }

 private:
  double both(std::size_t p, std::size_t i, std::size_t k) const { return potentials_[p](i, k); }
  double weight(std::uint32_t r) const {
    const double important = is_long(r, nt_) ? kLongWeight : (r & (r - 1)) == 0 ? kSmallPower : 1.0;
    return important / double(r * points_ / nt_);
  }

  std::uint32_t nt_;
  std::size_t points_;
  std::vector<std::uint32_t> lengths_;
  std::vector<Potential> potentials_;
  std::vector<std::uint32_t> order_;  // per tile and rank the point, numbered over all tiles
  std::vector<std::vector<double>> fields_;
};

}  // namespace

void rank_points(TileSet& set, std::uint64_t seed, std::uint32_t moves_per_point) {
  const std::uint32_t nt = set.points_per_tile;
  if (nt < 2) return;
  Ranking ranking(set);
  const std::size_t tiles = set.tile_count();
  const std::uint64_t moves = std::uint64_t(moves_per_point) * tiles * nt;
  for (std::uint64_t move = 0; move < moves; ++move) {
    const double cooling = 1 - double(move) / double(moves);
    const double temperature = kHeat / double(tiles) * cooling * cooling * cooling;
    const std::uint64_t bits = mix64(seed, kRankStream, move);
    const std::size_t tile = (bits >> 40) % tiles;
    std::uint32_t a = std::uint32_t(bits & 0xfffff) % nt, b = std::uint32_t(bits >> 20 & 0xfffff) % nt;
    if (a == b) continue;
    if (a > b) std::swap(a, b);
    const double change = ranking.change(tile, a, b);
    // Accepting by a threshold with a uniform random number needs no exponential.
    if (change < temperature * uniform64(seed, kRankStream + 1, move)) ranking.swap(tile, a, b);
  }
  const auto numbers = tile_numbers(set);
  for (std::size_t t = 0; t < numbers.size(); ++t) {
    auto& tile = set.tiles[numbers[t]];
    std::vector<TileSet::TilePoint> ordered;
    for (std::uint32_t r = 0; r < nt; ++r) ordered.push_back(tile[ranking.at(t, r)]);
    tile = std::move(ordered);
  }
}

}  // namespace capcon
