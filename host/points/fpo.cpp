#include "points/fpo.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "base/error.h"
#include "base/hash.h"
#include "points/checks.h"
#include "points/dynamic_voronoi.h"
#include "points/lattice.h"
#include "points/parted.h"

namespace capcon {

namespace {

constexpr int kPasses = 10;       // between two looks at the mean distance, which may fall for a pass
constexpr double kEnough = 4e-4;  // a smaller gain by that many passes is the end
// A point whose new place is near its old one goes on beyond it by so much of the way, as in overrelaxation:
// measured, 40 passes then get farther than 110 without.
constexpr double kBeyond = 0.7;
constexpr double kNear = 0.1;  // of the empty circle's radius

constexpr std::size_t kMostChecked = 256;  // points, each move by a look at all

enum Stream : std::uint64_t { kStart = 0x66706f31, kOrder };

/// The largest of n values that change one by one: a tree of maxima.
class Largest {
 public:
  explicit Largest(std::size_t n) {
    while (leaves_ < n) leaves_ *= 2;
    value_.assign(2 * leaves_, -1.0);
  }
  void set(std::size_t i, double value) {
    std::size_t k = leaves_ + i;
    value_[k] = value;
    while (k > 1) {
      k /= 2;
      const double above = std::max(value_[2 * k], value_[2 * k + 1]);
      if (value_[k] == above) break;
      value_[k] = above;
    }
  }
  std::uint32_t index() const {
    std::size_t k = 1;
    while (k < leaves_) k = value_[2 * k] == value_[k] ? 2 * k : 2 * k + 1;
    return static_cast<std::uint32_t>(k - leaves_);
  }

 private:
  std::size_t leaves_ = 1;
  std::vector<double> value_;
};

/// Squared distance from a cell's site to its farthest corner: the centre of an empty circle. -1 without a
/// cell.
double farthest2(const DynamicVoronoi::Cell& cell) {
  double best2 = -1;
  for (const auto& edge : cell) best2 = std::max(best2, glm::dot(edge.corner, edge.corner));
  return best2;
}

glm::dvec2 corner_at(const DynamicVoronoi::Cell& cell, double distance2) {
  for (const auto& edge : cell) {
    if (glm::dot(edge.corner, edge.corner) == distance2) return edge.corner;
  }
  return glm::dvec2(0);
}

double nearest2(const DynamicVoronoi& diagram, std::uint32_t i) {
  double best = 1;  // its own images
  for (const auto& edge : diagram.cell(i)) {
    const glm::dvec2 d = diagram.offset(i, edge.across);
    best = std::min(best, glm::dot(d, d));
  }
  return best;
}

glm::dvec2 wrapped(glm::dvec2 p) {
  p -= glm::floor(p);
  return {p.x < 1 ? p.x : 0, p.y < 1 ? p.y : 0};
}

class Optimiser {
 public:
  Optimiser(const Points& start, const FpoOptions& options)
      : global_(options.strategy == FpoOptions::Strategy::kGlobal),
        diagram_(start.size()),
        largest_(start.size()) {
    for (std::uint32_t i = 0; i < start.size(); ++i) diagram_.insert(i, start[i], i > 0 ? i - 1 : 0);
    for (std::uint32_t i = 0; i < start.size(); ++i) note(i);
    order_.resize(start.size());
    std::iota(order_.begin(), order_.end(), 0u);
    for (std::uint64_t k = order_.size(); k > 1; --k) {  // Fisher and Yates
      std::swap(order_[k - 1], order_[mix64(options.seed, kOrder, k) % k]);
    }
  }

  /// Returns how many points moved.
  std::uint32_t pass() {
    std::uint32_t moves = 0;
    for (const std::uint32_t i : order_) moves += move(i);
    if constexpr (kChecks) check_cells();
    return moves;
  }
  double mean_distance() const {
    double sum = 0;
    for (std::uint32_t i = 0; i < order_.size(); ++i) sum += std::sqrt(nearest2(diagram_, i));
    return sum / static_cast<double>(order_.size());
  }
  Points points() const {
    Points result(order_.size());
    for (std::uint32_t i = 0; i < result.size(); ++i) result[i] = diagram_.position(i);
    return result;
  }

 private:
  void note(std::uint32_t i) {
    if (global_) largest_.set(i, farthest2(diagram_.cell(i)));
  }
  void note_changed() {
    for (const std::uint32_t q : diagram_.changed()) note(q);
  }
  /// The site with the largest empty circle on its cell's rim.
  std::uint32_t find() const {
    if (global_) return largest_.index();
    std::uint32_t best = diagram_.changed().front();
    double best2 = -1;
    for (const std::uint32_t q : diagram_.changed()) {
      const double distance2 = farthest2(diagram_.cell(q));
      if (distance2 > best2) best = q, best2 = distance2;
    }
    return best;
  }
  /// A place beyond the centre of the empty circle as seen from the point's old place, if near and still
  /// better than that; else the centre.
  glm::dvec2 beyond(std::uint32_t i, std::uint32_t q, glm::dvec2 centre, double before2,
                    double after2) const {
    glm::dvec2 step = centre - diagram_.position(i);
    step -= glm::round(step);
    if (glm::dot(step, step) > kNear * kNear * after2) return centre;
    const glm::dvec2 place = wrapped(centre + kBeyond * step);
    const DynamicVoronoi::Image nearest = diagram_.nearest(place, q);
    const glm::dvec2 d = diagram_.position(nearest.site) + glm::dvec2(nearest.x, nearest.y) - place;
    return glm::dot(d, d) > before2 * (1 + 1e-9) ? place : centre;
  }
  bool move(std::uint32_t i) {
    const double before2 = nearest2(diagram_, i);
    diagram_.remove(i);
    note(i);
    note_changed();
    const std::uint32_t q = find();
    const double after2 = farthest2(diagram_.cell(q));
    // The gain must be above rounding, so that the distances, of which there are finitely many, can only
    // grow.
    const bool moves = after2 > before2 * (1 + 1e-9);
    if (moves) {
      const glm::dvec2 centre = diagram_.position(q) + corner_at(diagram_.cell(q), after2);
      diagram_.insert(i, beyond(i, q, wrapped(centre), before2, after2), q);
    } else {
      diagram_.undo_remove();
    }
    note_changed();
    if constexpr (kChecks) {
      if (order_.size() <= kMostChecked && moves)
        check_step(Checked::kFpo, before2 - true_nearest2(i), 0, before2);
    }
    return moves;
  }
  /// Squared distance from point i to the nearest other one or its own image, by a look at all.
  double true_nearest2(std::uint32_t i) const {
    double best = 1;
    for (std::uint32_t j = 0; j < order_.size(); ++j) {
      if (j == i) continue;
      glm::dvec2 d = diagram_.position(j) - diagram_.position(i);
      d -= glm::round(d);
      best = std::min(best, glm::dot(d, d));
    }
    return best;
  }
  void check_cells() const {
    double twice = 0;
    for (std::uint32_t i = 0; i < order_.size(); ++i) {
      const DynamicVoronoi::Cell& cell = diagram_.cell(i);
      for (std::size_t k = 0; k < cell.size(); ++k) {
        const glm::dvec2 a = cell[k].corner, b = cell[k + 1 < cell.size() ? k + 1 : 0].corner;
        twice += a.x * b.y - a.y * b.x;
      }
      const glm::dvec2 p = diagram_.position(i);
      require(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1, "fpo: a point is outside the square");
    }
    require(std::abs(0.5 * twice - 1) < 1e-9, "fpo: the cells do not cover the torus");
  }

  bool global_;
  DynamicVoronoi diagram_;
  Largest largest_;
  std::vector<std::uint32_t> order_;
};

}  // namespace

Points fpo_from(const Points& start, const FpoOptions& options) {
  if (start.size() < 2) return start;
  Optimiser optimiser(parted(start), options);
  double mean = optimiser.mean_distance(), first_gain = 0;
  // Ends: ten passes go on only if they raise the mean by a factor of 1 + kEnough, and it cannot exceed the
  // hexagonal lattice's.
  for (;;) {
    std::uint32_t moves = 1;
    for (int pass = 0; pass < kPasses && moves > 0; ++pass) moves = optimiser.pass();
    const double next = optimiser.mean_distance(), gain = next / mean - 1;
    mean = next;
    if (moves == 0 || !(gain >= kEnough)) break;
    // The gains fall about geometrically.
    if (first_gain == 0) first_gain = gain;
    if (options.on_progress)
      options.on_progress(std::log(gain / first_gain) / std::log(kEnough / first_gain));
  }
  return optimiser.points();
}

Points fpo(const FpoOptions& options) {
  if (options.n == 0) throw InputError("a point set needs at least one point (n >= 1)");
  std::vector<TorusPoint> random(options.n);
  for (std::uint32_t i = 0; i < options.n; ++i) {
    const std::uint64_t bits = mix64(options.seed, kStart, i);
    random[i] = {static_cast<std::uint32_t>(bits >> 32), static_cast<std::uint32_t>(bits)};
  }
  // Neighbours near each other: the next point is inserted close to the last. Equal places become different
  // ones.
  Points start;
  start.reserve(options.n);
  for (const std::uint32_t i : hilbert_order(random)) {
    start.push_back(wrapped(  // a coordinate just below 1 may round up to it
        {(random[i].x + uniform64(options.seed, kStart, options.n + 2ull * i)) * 0x1p-32,
         (random[i].y + uniform64(options.seed, kStart, options.n + 2ull * i + 1)) * 0x1p-32}));
  }
  return fpo_from(start, options);
}

}  // namespace capcon
