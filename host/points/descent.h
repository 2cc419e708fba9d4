#pragma once

#include <cstddef>
#include <deque>
#include <glm/vec2.hpp>
#include <vector>

namespace capcon {

/// Directions of limited-memory BFGS (Nocedal 1980) for a function of many places.
class DescentMemory {
 public:
  explicit DescentMemory(std::size_t pairs) : most_(pairs) {}

  /// What is learnt from a step and the change of the gradient along it; left out where the curvature is not
  /// positive.
  void learn(std::vector<glm::dvec2> step, std::vector<glm::dvec2> change);
  /// The step to where the gradient should vanish; `first_scale` times the negative gradient while nothing is
  /// known.
  std::vector<glm::dvec2> step_from(const std::vector<glm::dvec2>& gradient, double first_scale) const;
  void forget() { pairs_.clear(); }
  bool empty() const { return pairs_.empty(); }

 private:
  struct Pair {
    std::vector<glm::dvec2> step, change;
    double inverse = 0;  ///< 1 / (step . change)
  };
  std::size_t most_;
  std::deque<Pair> pairs_;
};

}  // namespace capcon
