#include "tiling/tied_optimiser.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "points/measure.h"
#include "tiling/mean_tile.h"

namespace capcon {
namespace {

constexpr int kGradientSteps = 8;
constexpr double kMargin =
    1e-4;  // points stay inside their tile by this times 1, 2, ...: never two at one place
constexpr double kReachInSpacings = 2;  // frequencies of the mean tile, in units of sqrt(nt)

glm::dvec2 into_tile(glm::dvec2 p, std::uint32_t slot) {
  const double margin = std::min(0.1, kMargin * (1 + slot));
  return {std::clamp(p.x, margin, 1 - margin), std::clamp(p.y, margin, 1 - margin)};
}

TiedPoints moved(TiedPoints points, const std::vector<glm::dvec2>& positions) {
  for (std::size_t i = 0; i < positions.size(); ++i)
    points.free[i].position = into_tile(positions[i], points.free[i].slot);
  return points;
}

// Lowers sum of mass |position - target|^2 + flatness * unevenness by gradient steps with backtracking.
TiedPoints flattened(TiedPoints points, const std::vector<double>& mass,
                     const std::vector<glm::dvec2>& target, double flatness, double reach) {
  const auto model = [&](const TiedPoints& p, std::vector<glm::dvec2>* gradient) {
    double value = flatness * mean_tile_unevenness(p, reach, gradient);
    for (std::size_t i = 0; i < p.free.size(); ++i) {
      const glm::dvec2 d = p.free[i].position - target[i];
      value += mass[i] * glm::dot(d, d);
      if (gradient) (*gradient)[i] = flatness * (*gradient)[i] + 2 * mass[i] * d;
    }
    return value;
  };
  std::vector<glm::dvec2> gradient, positions(target.size());
  double step = 1;
  for (int k = 0; k < kGradientSteps; ++k) {
    const double value = model(points, &gradient);
    for (; step > 1e-6; step /= 2) {
      for (std::size_t i = 0; i < positions.size(); ++i)
        positions[i] = points.free[i].position - gradient[i] * (step / (2 * std::max(mass[i], 1e-9)));
      if (TiedPoints next = moved(points, positions); model(next, nullptr) < value) {
        points = std::move(next);
        break;
      }
    }
    step = std::min(1.0, step * 2);
  }
  return points;
}

}  // namespace

TiedOptimiser::TiedOptimiser(TiedPoints points, std::vector<TrainingTiling> tilings, double flatness)
    : points_(std::move(points)), tilings_(std::move(tilings)), flatness_(flatness) {
  double weight = 0;
  for (const TrainingTiling& t : tilings_) weight += t.weight * t.tiling.size();
  for (TrainingTiling& t : tilings_) {
    t.weight /= weight;  // of one tile
    cells_.emplace_back(t.tiling, t.colours, points_);
  }
}

double TiedOptimiser::round(double tolerance, double stride) {
  parallel_for(cells_.size(), [&](std::size_t i) { cells_[i].solve(points_, tolerance); });

  // For fixed cells of equal area the energy is sum over free points of mass |position - target|^2 + a
  // constant.
  const double scale = points_.points_per_tile / kHexagonEnergy;
  std::vector<double> mass(points_.free.size());
  std::vector<glm::dvec2> target(points_.free.size(), glm::dvec2(0));
  energy_ = 0;
  for (std::size_t t = 0; t < cells_.size(); ++t) {
    energy_ += scale * tilings_[t].weight * tilings_[t].tiling.size() * cells_[t].energy();
    for (std::size_t site = 0; site < cells_[t].site_count(); ++site) {
      const PowerCell& cell = cells_[t].cells()[site];
      const std::uint32_t i = cells_[t].free_point(site);
      const double m = scale * tilings_[t].weight * cell.area;
      mass[i] += m;
      target[i] += m * cell.centroid;
    }
  }
  for (std::size_t i = 0; i < target.size(); ++i)
    target[i] = points_.free[i].position + (mass[i] > 0 ? target[i] / mass[i] : glm::dvec2(0));

  const double reach = kReachInSpacings * std::sqrt(double(points_.points_per_tile));
  const double objective = energy_ + (flatness_ > 0 ? flatness_ * mean_tile_unevenness(points_, reach) : 0.0);
  const TiedPoints best =
      flatness_ > 0 ? flattened(points_, mass, target, flatness_, reach) : moved(points_, target);
  for (std::size_t i = 0; i < target.size(); ++i) {
    glm::dvec2& position = points_.free[i].position;
    position = into_tile(position + stride * (best.free[i].position - position), best.free[i].slot);
  }
  return objective;
}

}  // namespace capcon
