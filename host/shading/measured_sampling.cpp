#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "shading/measured_brdf.h"
#include "shading/microfacet.h"
#include "shading/spectrum.h"

namespace capcon {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kRings = 160, kTurns = 48;

/// Calls visit(in, weight) over the hemisphere of `in`: midpoints in the half vector, denser towards the
/// normal, where glossy BRDFs have their peaks. d in = 4 (out . half) d half. `out` is in the plane y = 0,
/// and so half of the hemisphere is enough.
template <typename Visit>
void each_direction(const glm::dvec3& out, const Visit& visit) {
  for (int ring = 0; ring < kRings; ++ring) {
    const double t = (ring + 0.5) / kRings, theta = t * t * kPi / 2;
    const auto edge = [](int i) {
      return std::cos(static_cast<double>(i) * i / (kRings * kRings) * kPi / 2);
    };
    const double patch = (edge(ring) - edge(ring + 1)) * 2 * kPi / kTurns;
    for (int turn = 0; turn < kTurns; ++turn) {
      const double phi = (turn + 0.5) / kTurns * kPi;
      const glm::dvec3 half(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                            std::cos(theta));
      const double cosine = glm::dot(out, half);
      const glm::dvec3 in = 2 * cosine * half - out;
      if (cosine > 0 && in.z > 0) visit(in, 4 * cosine * patch);
    }
  }
}

glm::dvec3 direction(double cosine) {
  return {std::sqrt(std::max(0.0, 1 - cosine * cosine)), 0, cosine};
}

/// What the search needs of one pair of directions.
struct Pair {
  glm::dvec3 in, out;
  double square;  ///< (f cos / albedo)^2 times the quadrature's weight
};

std::vector<Pair> pairs_of(const MeasuredBrdf& brdf) {
  std::vector<Pair> pairs;
  for (const double degrees : {15.0, 30.0, 45.0, 60.0, 75.0}) {
    const glm::dvec3 out = direction(std::cos(degrees * kPi / 180));
    const double albedo = luminance(directional_albedo(brdf, out.z));
    if (!(albedo > 0)) continue;
    each_direction(out, [&](const glm::dvec3& in, double weight) {
      const double value = luminance(brdf(in, out)) * in.z / albedo;
      if (value > 0) pairs.push_back({in, out, value * value * weight});
    });
  }
  return pairs;
}

/// Tries every weight with this alpha and keeps what is better than `least`.
void try_alpha(const std::vector<Pair>& pairs, double alpha, double& least, MeasuredBrdf& best) {
  constexpr int kWeights = 20;  // steps of 0.05; the cosine keeps a part, or tails would be missed
  double moments[kWeights] = {};
  for (const Pair& pair : pairs) {
    const double facet = visible_normals_pdf(pair.in, pair.out, alpha), cosine = pair.in.z / kPi;
    for (int i = 0; i < kWeights; ++i) moments[i] += pair.square / (cosine + 0.05 * i * (facet - cosine));
  }
  for (int i = 0; i < kWeights; ++i) {
    if (!(moments[i] < least)) continue;
    least = moments[i];
    best.alpha = alpha;
    best.specular_weight = 0.05 * i;
  }
}

}  // namespace

glm::dvec3 directional_albedo(const MeasuredBrdf& brdf, double cosine) {
  const glm::dvec3 out = direction(cosine);
  glm::dvec3 sum(0);
  each_direction(out, [&](const glm::dvec3& in, double weight) { sum += brdf(in, out) * in.z * weight; });
  return sum;
}

void fit_sampling(MeasuredBrdf& brdf) {
  const std::vector<Pair> pairs = pairs_of(brdf);
  brdf.alpha = 1;
  brdf.specular_weight = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 24; ++i) try_alpha(pairs, std::pow(0.005, i / 24.0), least, brdf);
  const double coarse = brdf.alpha;  // steps of a factor 1.25; finer ones about the best
  for (int i = -4; i <= 4; ++i)
    try_alpha(pairs, std::clamp(coarse * std::pow(1.05, i), 0.005, 1.0), least, brdf);
}

}  // namespace capcon
