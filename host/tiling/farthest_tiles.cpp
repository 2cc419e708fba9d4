#include "tiling/farthest_tiles.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tuple>
#include <vector>

#include "tiling/mean_tile.h"
#include "tiling/tile_pairs.h"

namespace capcon {
namespace {

constexpr int kStages = 30;
constexpr double kFirst = 0.7, kLast = 0.93;  // diameters, in d_hex
constexpr int kSearchAgain = 20;              // steps between two searches for pairs
constexpr double kSearchReach = 1.25;         // in diameters
constexpr double kAtRest = 1e-4;              // overlap, in diameters
constexpr double kReachInSpacings = 2;        // frequencies of the mean tile, in units of sqrt(nt)
constexpr double kMargin = 1e-4;              // as in tied_optimiser.cpp: never two points at one place

double d_hex(const TiedPoints& points) {
  return std::sqrt(2 / (std::sqrt(3.0) * points.points_per_tile));
}

// Free points i and j that stand `shift` tiles from each other in some tiling.
struct Pair {
  std::uint32_t i, j;
  int dx, dy;
  auto key() const { return std::tie(i, j, dx, dy); }
};

// All pairs nearer than `reach` (below 1), each once. Half of the shifts: the others are the same pairs.
std::vector<Pair> pairs_within(const TiedPoints& points, double reach) {
  const auto numbers = tile_numbers(points.colours, points.colouring);
  std::vector<Pair> pairs;
  for (int dy = 0; dy <= 1; ++dy)
    for (int dx = dy == 0 ? 0 : -1; dx <= 1; ++dx)
      for (const std::uint32_t t : numbers)
        for (const std::uint32_t u : numbers) {
          const bool same = dx == 0 && dy == 0;
          if ((same && t != u) || !can_stand(points.colours, t, u, dx, dy)) continue;
          for (const std::uint32_t i : points.tiles[t])
            for (const std::uint32_t j : points.tiles[u]) {
              if (same && i >= j) continue;
              const glm::dvec2 d = points.free[j].position + glm::dvec2(dx, dy) - points.free[i].position;
              if (glm::dot(d, d) < reach * reach) pairs.push_back({i, j, dx, dy});
            }
        }
  std::ranges::sort(pairs, {}, &Pair::key);
  pairs.erase(std::ranges::unique(pairs, {}, &Pair::key).begin(), pairs.end());
  return pairs;
}

glm::dvec2 between(const TiedPoints& points, const Pair& pair) {
  return points.free[pair.j].position + glm::dvec2(pair.dx, pair.dy) - points.free[pair.i].position;
}

double dot(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += glm::dot(a[i], b[i]);
  return sum;
}

// The steps of FIRE: speed gathers while it goes downhill, and is lost where it does not.
class Fire {
 public:
  explicit Fire(std::size_t size) : speed_(size, glm::dvec2(0)) {}
  const std::vector<glm::dvec2>& step(const std::vector<glm::dvec2>& force) {
    const double power = dot(speed_, force);
    if (power > 0) {
      const double turn = std::sqrt(dot(speed_, speed_) / (dot(force, force) + 1e-30));
      for (std::size_t i = 0; i < speed_.size(); ++i)
        speed_[i] = (1 - steer_) * speed_[i] + steer_ * turn * force[i];
      if (++downhill_ > 5) time_ = std::min(1.1 * time_, 0.35), steer_ *= 0.99;
    } else {
      std::ranges::fill(speed_, glm::dvec2(0));
      time_ = std::max(time_ / 2, 0.01);
      steer_ = 0.1;
      downhill_ = 0;
    }
    for (std::size_t i = 0; i < speed_.size(); ++i) speed_[i] += time_ * force[i];
    return speed_;
  }
  double time() const { return time_; }

 private:
  std::vector<glm::dvec2> speed_;
  double time_ = 0.1, steer_ = 0.1;
  int downhill_ = 0;
};

// Lets discs of this diameter push each other apart.
void relax(TiedPoints& points, double diameter, std::uint32_t rounds, double flatness) {
  const double reach = kReachInSpacings * std::sqrt(double(points.points_per_tile));
  Fire fire(points.free.size());
  std::vector<Pair> pairs;
  std::vector<glm::dvec2> force(points.free.size()), slope;
  for (std::uint32_t round = 0; round < rounds; ++round) {
    if (round % kSearchAgain == 0) pairs = pairs_within(points, kSearchReach * diameter);
    std::ranges::fill(force, glm::dvec2(0));
    double most = 0;
    for (const Pair& pair : pairs) {
      const glm::dvec2 d = between(points, pair);
      const double length = glm::length(d), overlap = 1 - length / diameter;
      if (overlap <= 0) continue;
      most = std::max(most, overlap);
      const glm::dvec2 push = d * (overlap / (length + 1e-12));
      force[pair.i] -= push;
      force[pair.j] += push;
    }
    if (flatness > 0) {
      mean_tile_unevenness(points, reach, &slope, true);
      for (std::size_t i = 0; i < force.size(); ++i) force[i] -= flatness * slope[i];
    } else if (most < kAtRest) {
      return;
    }
    const std::vector<glm::dvec2>& speed = fire.step(force);
    for (std::size_t i = 0; i < force.size(); ++i) {
      glm::dvec2 move = speed[i] * (fire.time() * diameter / 2);
      const double length = glm::length(move), longest = diameter / 10;
      if (length > longest) move *= longest / length;
      const double margin = std::min(0.1, kMargin * (1 + points.free[i].slot));
      glm::dvec2& position = points.free[i].position;
      position = glm::clamp(position + move, glm::dvec2(margin), glm::dvec2(1 - margin));
    }
  }
}

}  // namespace

double least_distance(const TiedPoints& points) {
  double least = 1;  // a tile's own image
  for (const Pair& pair : pairs_within(points, 1))
    least = std::min(least, glm::length(between(points, pair)));
  return least / d_hex(points);
}

TiedPoints spread_apart(TiedPoints points, const FarthestOptions& options) {
  for (int stage = 0; stage < kStages; ++stage) {
    const double diameter = kFirst + (kLast - kFirst) * stage / (kStages - 1);
    relax(points, diameter * d_hex(points), options.rounds, options.flatness);
    if (options.on_stage) options.on_stage(double(stage + 1) / kStages, diameter);
  }
  return points;
}

}  // namespace capcon
