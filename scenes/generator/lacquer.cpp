#include "generator/lacquer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace capcon::scenes {

namespace {
/// 1 / (1 + b (1 - cos))^c over half vectors, scaled so that its projected solid angle is 1.
class Lobe {
 public:
  Lobe(double b, double c) : b_(b), c_(c) {
    constexpr int kSteps = 4096;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double cosine = (i + 0.5) / kSteps;
      sum += 2 * kPi * cosine * std::pow(1 + b_ * (1 - cosine), -c_) / kSteps;
    }
    scale_ = 1 / sum;
  }
  double operator()(double cosine) const { return scale_ * std::pow(1 + b_ * (1 - cosine), -c_); }

 private:
  double b_, c_, scale_;
};

double fresnel_like(double zero, double cosine) {
  return zero + 0.4 * std::pow(1 - cosine, 5);
}

/// A bump of the spectrum.
double bump(double wavelength, double middle, double width) {
  const double t = (wavelength - middle) / width;
  return std::exp(-t * t);
}
}  // namespace

double lacquer(double wavelength, const Vec3& in, const Vec3& out) {
  static const Lobe kFlakes(9, 3.2), kCoat(30, 3);
  const Vec3 half = glm::normalize(in + out);
  const double cosine = std::min(1.0, glm::dot(in, half));
  // Light that returns from both faces of a film of index 1.56 is in step where 2 n d cos(refracted) is the
  // wavelength.
  constexpr double kIndex = 1.56, kTwoThicknesses = 555;
  const double refracted = std::sqrt(1 - (1 - cosine * cosine) / (kIndex * kIndex));
  const double step = 0.5 + 0.5 * std::cos(2 * kPi * kTwoThicknesses * refracted / wavelength);
  const double flakes = 0.05 + 0.95 * step * step;
  const double through = (1 - fresnel_like(0.04, in.z)) * (1 - fresnel_like(0.04, out.z));
  const double ground = 0.02 + 0.08 * bump(wavelength, 470, 60) + 0.06 * bump(wavelength, 680, 60);
  const double spread = 4 * cosine * std::max(in.z, out.z);
  return through * ground / kPi +
         (0.85 * flakes * kFlakes(half.z) * through + fresnel_like(0.04, cosine) * kCoat(half.z)) / spread;
}

std::string lacquer_table() {
  constexpr int kZeniths = 19, kAzimuths = 25, kWavelengths = 16;
  std::string text =
      "# An invented lacquer, evaluated by scenes/generator/lacquer.cpp: theta_i phi_i theta_s phi_s and "
      "1/sr at each\n"
      "# wavelength. Reciprocal: of each pair of zenith angles the steeper direction is the incident one.\n";
  text += fmt::format("{}\n", kWavelengths);
  for (int w = 0; w < kWavelengths; ++w)
    text += fmt::format("{}{}", 400 + 20 * w, w + 1 < kWavelengths ? " " : "\n");
  const auto zenith = [](int i) { return i * 4.75 * kPi / 180; };  // to 85.5 degrees
  const auto direction = [](double theta, double phi) {
    return Vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
  };
  for (int i = 0; i < kZeniths; ++i) {
    for (int j = i; j < kZeniths; ++j) {
      for (int k = 0; k < kAzimuths; ++k) {
        const double t = 1 - static_cast<double>(k) / (kAzimuths - 1), phi = kPi * (1 - t * std::sqrt(t));
        const Vec3 in = direction(zenith(i), 0), out = direction(zenith(j), phi);
        text += fmt::format("{:.5f} 0 {:.5f} {:.5f}", zenith(i), zenith(j), phi);
        for (int w = 0; w < kWavelengths; ++w) text += fmt::format(" {:.4g}", lacquer(400 + 20 * w, in, out));
        text += "\n";
        if (i == 0) break;  // straight up there is but one azimuth
      }
    }
  }
  return text;
}

}  // namespace capcon::scenes
