#include "image/flip_filters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace capcon {
namespace {

using Taps = FlipFilters::Taps;

/// a exp(-b f^2) of a frequency f in cycles a degree: a Gaussian in space too.
struct Term {
  double a, b;
};

double sum(const Taps& taps) {
  double total = 0;
  for (const double tap : taps) total += tap;
  return total;
}

FlipFilters::Sensitivity sensitivity(const std::vector<Term>& terms, int radius, double pixels_per_degree) {
  constexpr double kPi = std::numbers::pi;
  FlipFilters::Sensitivity filter;
  double total = 0;
  for (const Term& term : terms) {
    // a sqrt(pi / b) exp(-pi^2 (x^2 + y^2) / b), shared out to both directions
    const double height = std::sqrt(term.a * std::sqrt(kPi / term.b));
    Taps taps;
    for (int i = -radius; i <= radius; ++i) {
      const double degrees = i / pixels_per_degree;
      taps.push_back(height * std::exp(-kPi * kPi * degrees * degrees / term.b));
    }
    total += sum(taps) * sum(taps);
    filter.parts.push_back(std::move(taps));
  }
  for (Taps& part : filter.parts) {
    for (double& tap : part) tap /= std::sqrt(total);
  }
  return filter;
}

/// Positive taps of sum 1, negative ones of -1.
void balance(Taps& taps) {
  double positive = 0, negative = 0;
  for (const double tap : taps) (tap > 0 ? positive : negative) += std::abs(tap);
  for (double& tap : taps) tap /= tap > 0 ? positive : negative;
}

}  // namespace

FlipFilters::FlipFilters(double pixels_per_degree) {
  constexpr double kPi = std::numbers::pi;
  // The widest of the sensitivities decides how far all of them reach: three standard deviations of it.
  constexpr Term kAchromatic{1, 0.0047}, kRedGreen{1, 0.0053}, kBlueYellow{34.1, 0.04},
      kBlueYellowToo{13.5, 0.025};
  blur_radius =
      static_cast<int>(std::ceil(3 * std::sqrt(kBlueYellow.b / (2 * kPi * kPi)) * pixels_per_degree));
  achromatic = sensitivity({kAchromatic}, blur_radius, pixels_per_degree);
  red_green = sensitivity({kRedGreen}, blur_radius, pixels_per_degree);
  blue_yellow = sensitivity({kBlueYellow, kBlueYellowToo}, blur_radius, pixels_per_degree);

  constexpr double kEdgeDegrees = 0.082;  // between the extremes of the eye's edge detector
  const double deviation = kEdgeDegrees / 2 * pixels_per_degree;
  feature_radius = static_cast<int>(std::ceil(3 * deviation));
  for (int i = -feature_radius; i <= feature_radius; ++i) {
    const double t = i / deviation;
    const double gauss = std::exp(-t * t / 2);
    smooth.push_back(gauss);
    edge.push_back(-i * gauss);
    point.push_back((t * t - 1) * gauss);
  }
  const double total = sum(smooth);
  for (double& tap : smooth) tap /= total;
  balance(edge);
  balance(point);
}

}  // namespace capcon
