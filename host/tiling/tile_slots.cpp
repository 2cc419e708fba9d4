#include "tiling/tile_slots.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "base/hash.h"

namespace capcon {
namespace {

constexpr std::uint64_t kSlotStream = 0x736c6f74;
constexpr std::uint64_t kStarts = 16;

/// The sum of squared distances to the slots' means falls as the sum of squares of the slots' sums rises.
class Matching {
 public:
  Matching(const TileSet& set, std::uint32_t ranks) : ranks_(ranks), rank_(set.tiles.size()), sums_(ranks) {
    for (const auto& tile : set.tiles) {
      points_.emplace_back();
      for (std::uint32_t r = 0; r < ranks && !tile.empty(); ++r)
        points_.back().push_back(to_double(tile[r].position));
    }
  }

  void start(std::uint64_t seed) {
    std::fill(sums_.begin(), sums_.end(), glm::dvec2(0));
    for (std::size_t t = 0; t < rank_.size(); ++t) {
      rank_[t].resize(points_[t].size());
      std::iota(rank_[t].begin(), rank_[t].end(), 0u);
      for (std::size_t i = rank_[t].size(); i > 1; --i)
        std::swap(rank_[t][i - 1], rank_[t][mix64(seed, kSlotStream + t, i) % i]);
      for (std::size_t s = 0; s < rank_[t].size(); ++s) sums_[s] += at(t, s);
    }
    while (pass()) {
    }
  }

  double sum_of_squares() const {
    return std::accumulate(sums_.begin(), sums_.end(), 0.0,
                           [](double sum, glm::dvec2 s) { return sum + glm::dot(s, s); });
  }

  TileSlots result() const {
    TileSlots slots{rank_, {}, 0};
    double tiles = 0, squares = 0;
    for (const auto& tile : points_) {
      tiles += tile.empty() ? 0 : 1;
      for (const glm::dvec2 p : tile) squares += glm::dot(p, p);
    }
    for (const glm::dvec2 s : sums_) slots.place.push_back(s / tiles);
    slots.deviation = std::sqrt(std::max(0.0, (squares - sum_of_squares() / tiles) / (tiles * ranks_)));
    return slots;
  }

 private:
  glm::dvec2 at(std::size_t tile, std::size_t slot) const { return points_[tile][rank_[tile][slot]]; }

  bool pass() {
    bool any = false;
    for (std::size_t t = 0; t < rank_.size(); ++t) {
      for (std::size_t a = 0; a < rank_[t].size(); ++a) {
        for (std::size_t b = a + 1; b < rank_[t].size(); ++b) {
          const glm::dvec2 step = at(t, b) - at(t, a);
          // |A + d|^2 + |B - d|^2 - |A|^2 - |B|^2
          if (glm::dot(sums_[a] - sums_[b], step) + glm::dot(step, step) < 1e-12) continue;
          sums_[a] += step;
          sums_[b] -= step;
          std::swap(rank_[t][a], rank_[t][b]);
          any = true;
        }
      }
    }
    return any;
  }

  std::uint32_t ranks_;
  std::vector<Points> points_;
  std::vector<std::vector<std::uint32_t>> rank_;
  Points sums_;
};

}  // namespace

TileSlots match_slots(const TileSet& set, std::uint32_t ranks) {
  Matching matching(set, ranks);
  std::uint64_t best = 0;
  double most = -1;
  for (std::uint64_t seed = 0; seed < kStarts; ++seed) {
    matching.start(seed);
    if (matching.sum_of_squares() > most) most = matching.sum_of_squares(), best = seed;
  }
  matching.start(best);
  return matching.result();
}

}  // namespace capcon
