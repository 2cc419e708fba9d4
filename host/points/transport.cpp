#include "points/transport.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <utility>

#include "base/error.h"
#include "base/hash.h"
#include "points/lattice.h"
#include "points/measure.h"

namespace capcon {

Laplacian area_derivatives(const PowerDiagram& diagram, std::span<const glm::dvec2> sites) {
  Laplacian matrix;
  matrix.column.reserve(6 * sites.size());
  matrix.weight.reserve(6 * sites.size());
  for (std::uint32_t i = 0; i < sites.size(); ++i) {
    for (const PowerDiagram::Edge& edge : diagram.edges(i)) {
      const std::uint32_t j = edge.beyond.site();
      if (j == i || !(edge.length > 0)) continue;
      const glm::dvec2 d = (sites[j] - sites[i]) + glm::dvec2(edge.beyond.x(), edge.beyond.y());
      matrix.add(j, 0.5 * edge.length / glm::length(d));
    }
    matrix.end_row();
  }
  return matrix;
}

Transport::Transport(Points sites, std::vector<double> shares)
    : Transport(std::move(sites), std::move(shares), {}) {}

Transport::Transport(Points sites, std::vector<double> shares, std::vector<double> weights)
    : sites_(std::move(sites)), shares_(std::move(shares)), weights_(std::move(weights)) {
  weights_.resize(sites_.size(), 0.0);
  diagram_.compute(sites_, weights_, nullptr, 0);
}

double Transport::area_error() const {
  double worst = 0;
  for (std::size_t i = 0; i < sites_.size(); ++i)
    worst = std::max(worst, std::abs(diagram_.moments(i).area / shares_[i] - 1));
  return worst;
}

double Transport::cost() const {
  double sum = 0;
  for (std::size_t i = 0; i < sites_.size(); ++i) sum += diagram_.moments(i).second;
  return sum;
}

void Transport::balance(double tolerance) {
  const std::size_t n = sites_.size();
  double least = 1;  // no cell may become smaller than half of this times its share
  for (std::size_t i = 0; i < n; ++i) least = std::min(least, diagram_.moments(i).area / shares_[i]);
  if (!(least > 0)) throw Failure("two sites have the same place: no weights can part their cells");
  const auto missing = [&](const PowerDiagram& diagram, std::vector<double>& out) {
    double sum2 = 0;
    out.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      out[i] = shares_[i] - diagram.moments(i).area;
      sum2 += out[i] * out[i];
    }
    return std::sqrt(sum2);
  };
  std::vector<double> gap, trial_gap, step, weights(n);
  PowerDiagram trial;
  LaplacianSolver solver;
  double norm = missing(diagram_, gap);
  for (int round = 0; area_error() > tolerance; ++round) {
    if (round == 500)
      throw Failure("the power cells do not become equal; are points crowded in tiny clusters?");
    solver.set(area_derivatives(diagram_, sites_));
    solver.solve(gap, 1e-4, 1000, step);
    bool taken = false;
    for (double part = 1; part > 1e-9 && !taken; part /= 2) {
      for (std::size_t i = 0; i < n; ++i) weights[i] = weights_[i] + part * step[i];
      double smallest = 1;
      for (const double share : shares_) smallest = std::min(smallest, share);
      if (!trial.compute(sites_, weights, &diagram_, 0.5 * least * smallest)) continue;
      const double trial_norm = missing(trial, trial_gap);
      if (trial_norm > (1 - 0.5 * part) * norm && area_error() > 1e-8) continue;
      taken = true;
      norm = trial_norm;
      gap.swap(trial_gap);
      std::swap(diagram_, trial);
      weights_.swap(weights);
    }
    if (!taken) throw Failure("the power cells do not become equal; are points crowded in tiny clusters?");
  }
}

namespace {

/// Sites so near to each other that their bisector is lost in rounding become one.
class Merger {
 public:
  explicit Merger(std::size_t n) : width_(1e-7 / std::sqrt(static_cast<double>(n))) {
    cells_ = static_cast<std::int64_t>(1 / width_);
    width_ = 1 / static_cast<double>(cells_);
  }
  void add(glm::dvec2 p, double mass) {
    const auto x = static_cast<std::int64_t>(p.x * static_cast<double>(cells_));
    const auto y = static_cast<std::int64_t>(p.y * static_cast<double>(cells_));
    for (int k = 0; k < 9; ++k) {
      const auto found = first_.find(key(x + k % 3 - 1, y + k / 3 - 1));
      if (found == first_.end()) continue;
      glm::dvec2 d = sites[found->second] - p;
      d -= glm::round(d);
      if (glm::dot(d, d) > 2 * width_ * width_) continue;
      shares[found->second] += mass;
      return;
    }
    first_.emplace(key(x, y), sites.size());
    sites.push_back(p);
    shares.push_back(mass);
  }

  Points sites;
  std::vector<double> shares;

 private:
  __extension__ using Key = unsigned __int128;
  struct Hash {
    std::size_t operator()(Key k) const {
      return mix64(0, static_cast<std::uint64_t>(k >> 64), static_cast<std::uint64_t>(k));
    }
  };
  Key key(std::int64_t x, std::int64_t y) const {
    return static_cast<Key>((x + cells_) % cells_) << 64 | static_cast<Key>((y + cells_) % cells_);
  }

  double width_;
  std::int64_t cells_;
  std::unordered_map<Key, std::size_t, Hash>
      first_;  ///< at most one site a cell: others are near enough to it
};

/// Weights that cut the torus as the sites would if their cluster were blown up about its middle, to half of
/// the torus: |x - c - f (s - c)|^2 and |x - s|^2 - (1 - f) |s - c|^2 have the same least s. From weights of
/// 0, all cells but those at a cluster's rim begin next to empty, and Newton's steps with them. Empty where
/// the sites are no cluster.
std::vector<double> blown_up(const Points& sites) {
  glm::dvec2 low(0), high(0), middle(0);
  std::vector<glm::dvec2> from_first;
  for (const glm::dvec2& site : sites) {
    glm::dvec2 d = site - sites.front();
    d -= glm::round(d);
    from_first.push_back(d);
    low = glm::min(low, d);
    high = glm::max(high, d);
    middle += d / static_cast<double>(sites.size());
  }
  const double size = std::max(high.x - low.x, high.y - low.y);
  if (!(size > 0 && size < 0.25)) return {};
  std::vector<double> weights;
  for (const glm::dvec2& d : from_first)
    weights.push_back((1 - 0.5 / size) * glm::dot(d - middle, d - middle));
  return weights;
}

}  // namespace

double transport_energy(const Points& points) {
  if (points.empty()) return 0;
  const double n = static_cast<double>(points.size());
  std::vector<TorusPoint> keys;  // neighbours near each other in memory
  for (const glm::dvec2& p : points)
    keys.push_back({static_cast<std::uint32_t>(p.x * 0x1p32), static_cast<std::uint32_t>(p.y * 0x1p32)});
  Merger merged(points.size());
  for (const std::uint32_t i : hilbert_order(keys)) merged.add(points[i], 1 / n);
  const auto energy = [&](std::vector<double> weights) {
    Transport transport(merged.sites, merged.shares, std::move(weights));
    transport.balance(1e-10);
    return n * transport.cost() / kHexagonEnergy;
  };
  try {
    return energy({});
  } catch (const Failure&) {
    std::vector<double> weights = blown_up(merged.sites);
    if (weights.empty()) throw;
    return energy(std::move(weights));
  }
}

}  // namespace capcon
