#include "points/transport_finish.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "points/checks.h"
#include "points/descent.h"
#include "points/measure.h"
#include "points/mirrors.h"
#include "points/parted.h"
#include "points/transport.h"

namespace capcon {

namespace {

constexpr std::size_t kMemory = 8;
constexpr double kLeastArea = 0.2;  // of a cell in a step, as part of its share

/// Sites, weights and their diagram, with what the descent wants to know.
struct Place {
  Points sites;
  std::vector<double> weights;
  PowerDiagram diagram;
  std::vector<glm::dvec2> gradient;  ///< site - centroid
  double energy = 0;                 ///< dual value: to second order in the areas' errors the balanced energy

  void assess(bool square) {
    const double share = 1 / static_cast<double>(sites.size());
    gradient.resize(sites.size());
    double sum = 0;
    for (std::size_t i = 0; i < sites.size(); ++i) {
      const Moments& m = diagram.moments(i);
      gradient[i] = -m.first / m.area;
      sum += m.second - weights[i] * (m.area - share);
    }
    if (square) make_alike(gradient);
    energy = static_cast<double>(sites.size()) * sum / kHexagonEnergy;
  }
};

/// What the areas lack after the sites' move, to first order: an edge at p is pushed out by (p - x_i) . move
/// / d when its own site moves, and pulled in by the other's.
void missing_areas(const Place& place, const std::vector<glm::dvec2>& move, std::vector<double>& missing) {
  const double share = 1 / static_cast<double>(place.sites.size());
  missing.resize(place.sites.size());
  for (std::uint32_t i = 0; i < place.sites.size(); ++i) {
    double area = place.diagram.moments(i).area;
    for (const PowerDiagram::Edge& edge : place.diagram.edges(i)) {
      const std::uint32_t j = edge.beyond.site();
      if (j == i) continue;
      const glm::dvec2 d = (place.sites[j] - place.sites[i]) + glm::dvec2(edge.beyond.x(), edge.beyond.y());
      const double push = glm::dot(edge.middle, move[i]) - glm::dot(edge.middle - d, move[j]);
      area += edge.length * push / glm::length(d);
    }
    missing[i] = share - area;
  }
}

bool outside(const Points& sites) {
  for (const glm::dvec2& s : sites) {
    if (std::min(s.x, s.y) < -0.4 || std::max(s.x, s.y) > 1.4) return true;
  }
  return false;
}

glm::dvec2 wrapped(glm::dvec2 p) {
  p -= glm::floor(p);
  return {p.x < 1 ? p.x : 0, p.y < 1 ? p.y : 0};
}

/// The areas add up to the torus but for 1e-9 (as the diagram itself demands), none is empty, and the energy,
/// which is what `taken` compares, rose by nothing at all.
void check_round(const Place& before, const Place& after) {
  double area = 0;
  for (std::size_t i = 0; i < after.sites.size(); ++i) {
    const Moments& m = after.diagram.moments(i);
    require(m.area > 0 && std::isfinite(m.second), "transport finish: a cell is empty");
    require(std::isfinite(after.sites[i].x) && std::isfinite(after.sites[i].y),
            "transport finish: a site is nowhere");
    area += m.area;
  }
  require(std::abs(area - 1) < 1e-9, "transport finish: the cells do not cover the torus");
  check_step(Checked::kTransport, after.energy - before.energy, 1e-300, before.energy);
}

}  // namespace

FinishResult transport_finish(const Points& points, const FinishOptions& options) {
  FinishResult result;
  if (points.empty()) return result;
  const bool square = options.square;
  const std::size_t n = square ? 4 * points.size() : points.size();
  const std::vector<double> shares(n, 1 / static_cast<double>(n));
  Place now, next;
  {
    Transport start(square ? mirrored(parted(points)) : parted(points), shares);
    start.balance(1e-3);
    now.sites = start.sites();
    now.weights = start.weights();
    now.diagram = start.diagram();
  }
  now.assess(square);
  DescentMemory memory(kMemory);
  LaplacianSolver solver;
  std::vector<double> missing, change;
  std::deque<double> energies;
  for (; result.rounds < options.most_rounds; ++result.rounds) {
    if (options.stop && options.stop(result.rounds, now.energy)) {
      result.stopped = true;
      break;
    }
    energies.push_back(now.energy);
    if (energies.size() > 20) {
      if (energies.front() - now.energy < 20 * options.tolerance * now.energy) break;
      energies.pop_front();
    }
    std::vector<glm::dvec2> move = memory.step_from(now.gradient, 1);
    solver.set(area_derivatives(now.diagram, now.sites));
    bool taken = false;
    for (int tries = 0; tries < 30 && !taken; ++tries) {
      missing_areas(now, move, missing);
      solver.solve(missing, 0.1, 100, change);
      if (square) make_alike(change), make_alike(move);
      next.sites.resize(n);
      next.weights.resize(n);
      for (std::size_t i = 0; i < n; ++i) {
        next.sites[i] = now.sites[i] + move[i];
        next.weights[i] = now.weights[i] + change[i];
      }
      if (next.diagram.compute(next.sites, next.weights, &now.diagram, kLeastArea / static_cast<double>(n))) {
        next.assess(square);
        taken = next.energy <= now.energy;
      }
      if (!taken && !memory.empty()) {
        memory.forget();
        move = memory.step_from(now.gradient, 1);
      } else if (!taken) {
        for (glm::dvec2& m : move) m *= 0.5;
      }
    }
    if (!taken) break;
    std::vector<glm::dvec2> turn(n);
    for (std::size_t i = 0; i < n; ++i) turn[i] = next.gradient[i] - now.gradient[i];
    memory.learn(std::move(move), std::move(turn));
    if constexpr (kChecks) check_round(now, next);
    std::swap(now, next);
    if (outside(now.sites)) {
      for (glm::dvec2& s : now.sites) s = wrapped(s);
      now.diagram.compute(now.sites, now.weights, nullptr, 0);
    }
  }
  for (const glm::dvec2& s : now.sites) result.points.push_back(wrapped(s));
  Transport end(result.points, shares, std::move(now.weights));
  end.balance(1e-10);
  result.energy = static_cast<double>(n) * end.cost() / kHexagonEnergy;
  result.area_error = end.area_error();
  if (square) result.points = unmirrored(result.points);
  return result;
}

}  // namespace capcon
