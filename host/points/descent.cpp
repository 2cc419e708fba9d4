#include "points/descent.h"

#include <glm/geometric.hpp>
#include <utility>

namespace capcon {

namespace {

double inner(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += glm::dot(a[i], b[i]);
  return sum;
}

void add(std::vector<glm::dvec2>& a, double factor, const std::vector<glm::dvec2>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
}

}  // namespace

void DescentMemory::learn(std::vector<glm::dvec2> step, std::vector<glm::dvec2> change) {
  const double curvature = inner(step, change);
  if (!(curvature > 1e-12 * inner(step, step))) return;
  if (pairs_.size() == most_) pairs_.pop_front();
  pairs_.push_back({std::move(step), std::move(change), 1 / curvature});
}

std::vector<glm::dvec2> DescentMemory::step_from(const std::vector<glm::dvec2>& gradient,
                                                 double first_scale) const {
  std::vector<glm::dvec2> step = gradient;
  std::vector<double> along(pairs_.size());
  for (std::size_t k = pairs_.size(); k-- > 0;) {
    along[k] = pairs_[k].inverse * inner(pairs_[k].step, step);
    add(step, -along[k], pairs_[k].change);
  }
  double scale = first_scale;
  if (!pairs_.empty())
    scale = 1 / (pairs_.back().inverse * inner(pairs_.back().change, pairs_.back().change));
  for (glm::dvec2& s : step) s *= scale;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const double back = pairs_[k].inverse * inner(pairs_[k].change, step);
    add(step, along[k] - back, pairs_[k].step);
  }
  for (glm::dvec2& s : step) s = -s;
  return step;
}

}  // namespace capcon
