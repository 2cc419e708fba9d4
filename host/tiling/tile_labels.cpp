#include "tiling/tile_labels.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "base/hash.h"
#include "tiling/tile_pairs.h"

namespace capcon {
namespace {

// Of the repulsion, in spacings of the hexagonal lattice of a part's points. Tried: 1 to 1.5, powers 2, 4
// and 8.
constexpr double kReach = 1.3;
constexpr double kHeat = 0.5;  // first temperature, in repulsion of one point
constexpr std::uint64_t kLabelStream = 0x6c6162656c;

/// The state of the annealing: labels, and how much every point would be repelled under each.
class Labelling {
 public:
  Labelling(const TileSet& set, std::uint32_t parts)
      : nt_(set.points_per_tile),
        parts_(parts),
        points_(set.tile_count() * nt_),
        numbers_(tile_numbers(set)),
        repulsion_(points_ * points_),
        labels_(points_),
        fields_(points_ * parts) {
    TilePairs pairs(set, 0);
    const double reach2 = kReach * kReach * 2 * parts / (std::sqrt(3.0) * nt_);
    const int far = int(std::ceil(std::sqrt(reach2)));
    for (int dy = -far; dy <= far; ++dy)
      for (int dx = -far; dx <= far; ++dx) add(set, {dx, dy}, pairs.at(dx, dy), reach2);
    for (std::size_t i = 0; i < points_; ++i) labels_[i] = std::uint32_t(i % parts);
    for (std::size_t i = 0; i < points_; ++i)
      for (std::size_t k = 0; k < points_; ++k) fields_[k * parts + labels_[i]] += both(i, k);
  }

  std::size_t points() const { return points_; }

  /// By how much all repulsion changes when two points of a tile exchange labels.
  double change(std::size_t i, std::size_t k) const {
    const std::uint32_t a = labels_[i], b = labels_[k];
    if (a == b) return 0;
    // Both sums count the pair, which has no label in common before and after.
    return field(i, b) - field(i, a) + field(k, a) - field(k, b) - 2 * both(i, k) + both(i, i) + both(k, k);
  }

  void swap(std::size_t i, std::size_t k) {
    const std::uint32_t a = labels_[i], b = labels_[k];
    for (std::size_t j = 0; j < points_; ++j) {
      const double moved = both(i, j) - both(k, j);
      fields_[j * parts_ + a] -= moved;
      fields_[j * parts_ + b] += moved;
    }
    std::swap(labels_[i], labels_[k]);
  }

  TileLabels result(const TileSet& set) const {
    TileLabels labels(set.tiles.size());
    for (std::size_t t = 0; t < numbers_.size(); ++t)
      labels[numbers_[t]].assign(labels_.begin() + std::ptrdiff_t(t * nt_),
                                 labels_.begin() + std::ptrdiff_t((t + 1) * nt_));
    return labels;
  }

 private:
  double both(std::size_t i, std::size_t k) const { return repulsion_[i * points_ + k]; }
  double field(std::size_t i, std::uint32_t label) const { return fields_[i * parts_ + label]; }

  /// Of i at k and of k at i: shifts come in pairs of opposite ones, which add up to both.
  void add(const TileSet& set, glm::dvec2 shift, const std::vector<double>& weights, double reach2) {
    const std::size_t tiles = numbers_.size();
    for (std::size_t t = 0; t < tiles; ++t) {
      for (std::size_t u = 0; u < tiles; ++u) {
        if (weights[t * tiles + u] == 0) continue;
        for (std::uint32_t i = 0; i < nt_; ++i) {
          for (std::uint32_t k = 0; k < nt_; ++k) {
            const glm::dvec2 d = to_double(set.tiles[numbers_[u]][k].position) + shift -
                                 to_double(set.tiles[numbers_[t]][i].position);
            const double s = 1 - glm::dot(d, d) / reach2;
            if (s <= 0 || (t == u && i == k && shift == glm::dvec2(0))) continue;
            repulsion_[(t * nt_ + i) * points_ + u * nt_ + k] += weights[t * tiles + u] * s * s * s * s;
          }
        }
      }
    }
  }

  std::uint32_t nt_, parts_;
  std::size_t points_;
  std::vector<std::uint32_t> numbers_;
  std::vector<double> repulsion_;
  std::vector<std::uint32_t> labels_;
  std::vector<double> fields_;  ///< [point * parts + label]
};

}  // namespace

TileLabels label_parts(const TileSet& set, std::uint32_t parts, std::uint64_t seed,
                       std::uint32_t moves_per_point) {
  Labelling labelling(set, parts);
  const std::uint32_t nt = set.points_per_tile;
  const std::uint64_t moves = std::uint64_t(moves_per_point) * labelling.points();
  for (std::uint64_t move = 0; parts > 1 && move < moves; ++move) {
    const double cooling = 1 - double(move) / double(moves);
    const std::uint64_t bits = mix64(seed, kLabelStream, move);
    const std::size_t i = (bits >> 32) % labelling.points(), k = i - i % nt + (bits & 0xffffffff) % nt;
    const double change = labelling.change(i, k);
    // Accepting by a threshold with a uniform random number needs no exponential.
    if (change != 0 && change < kHeat * cooling * cooling * cooling * uniform64(seed, kLabelStream + 1, move))
      labelling.swap(i, k);
  }
  return labelling.result(set);
}

}  // namespace capcon
