#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/hash.h"

namespace capcon::integrate {

/// Where an integrand lives. Points come in the unit square; those of a disk integrand go through the
/// concentric map first.
enum class Domain : std::uint8_t { square, torus, disk };

/// Sum of weights[i] f(points[i]), or the mean of f over the points when `weights` is empty.
using Average = std::function<double(std::span<const glm::dvec2> points, std::span<const double> weights)>;

/// The least upper bounds that the second-derivative bound needs, over the domain.
struct Smoothness {
  double gradient = 0;  ///< of |grad f|
  double hessian = 0;   ///< of the spectral norm of f's matrix of second derivatives
};

/// One integrand of a family. Areas are normalised: the domain's is 1, so that integral and mean are the
/// same.
struct Draw {
  Average average;
  double integral = 0;
  double sigma = 0;  ///< standard deviation of f(x), x uniform in the domain
  std::optional<double>
      variation;  ///< Hardy and Krause's on the unit square, anchored at (1,1); none: infinite or unknown
  std::optional<Smoothness> smooth;  ///< none: not twice differentiable
};

/// A density that follows f, and how to draw from it.
struct Importance {
  std::string density;                          ///< in words
  std::function<glm::dvec2(glm::dvec2)> place;  ///< uniform in the square to that density
  std::function<double(glm::dvec2)> value;      ///< the density
  double sigma = 0;                             ///< standard deviation of f / density under it
};

struct Integrand {
  std::string name;
  std::string title;
  std::string formula;  ///< f and its integral, in one or two sentences
  Domain domain = Domain::square;
  bool edges = false;   ///< f jumps
  bool family = false;  ///< each trial draws its own f; else all have the same
  std::string variation_note;
  std::function<Draw(std::uint64_t seed, std::uint64_t trial)> draw;
  std::optional<Importance> importance;
  std::string no_importance;  ///< why there is none
};

/// disk half-plane smooth-periodic smooth product soft-shadow peak, and on the disk: edge blocker leaves
/// smooth-disk shaded-edge.
const std::vector<Integrand>& battery();
const Integrand& find_integrand(std::string_view name);  ///< InputError with the names there are

// The battery's parts.
std::vector<Integrand> smooth_integrands();
std::vector<Integrand> edge_integrands();
std::vector<Integrand> disk_integrands();

/// Random numbers of one draw, addressed by (seed, integrand, trial, counter).
class Dice {
 public:
  Dice(std::uint64_t seed, std::string_view integrand, std::uint64_t trial)
      : seed_(seed), stream_(fnv1a64(integrand)), counter_(trial << 20) {}
  double next() { return uniform64(seed_, stream_, counter_++); }
  double next(double low, double high) { return low + (high - low) * next(); }

 private:
  std::uint64_t seed_, stream_, counter_;
};

/// The loop over the points with f compiled into it.
template <class Function>
Average average_of(Function f) {
  return [f](std::span<const glm::dvec2> points, std::span<const double> weights) {
    double sum = 0;
    if (weights.empty()) {
      for (const glm::dvec2& p : points) sum += f(p);
      return sum / static_cast<double>(points.size());
    }
    for (std::size_t i = 0; i < points.size(); ++i) sum += weights[i] * f(points[i]);
    return sum;
  };
}

}  // namespace capcon::integrate
