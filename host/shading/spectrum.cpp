#include "shading/spectrum.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "scene/number_text.h"

namespace capcon {
namespace {

constexpr int kFirst = 380, kLast = 780;  // nm; the matching functions are below 1e-3 outside

/// A Gaussian of two halves, as in the paper.
double lobe(double wavelength, double centre, double width_below, double width_above) {
  const double t = (wavelength - centre) / (wavelength < centre ? width_below : width_above);
  return std::exp(-0.5 * t * t);
}

/// Integral of value x matching functions, by 1 nm; `value` gives the spectrum at a wavelength.
template <typename Value>
glm::dvec3 integral(const Value& value) {
  glm::dvec3 sum(0);
  for (int nm = kFirst; nm <= kLast; ++nm) sum += value(nm) * colour_matching(nm);
  return sum;
}

glm::dvec3 integral_of_one() {
  static const glm::dvec3 kOne = integral([](double) { return 1.0; });
  return kOne;
}

template <typename Value>
glm::dvec3 emission(const Value& value) {
  return rgb_of_xyz(integral(value) / integral_of_one().y);
}

glm::dvec3 white() {
  return rgb_of_xyz(integral_of_one() / integral_of_one().y);
}

/// Where `wavelength` lies: between sample `first` and the next, a part `t` of the way.
struct Position {
  std::size_t first;
  double t;
};

Position locate(const std::vector<double>& wavelengths, double wavelength) {
  if (wavelengths.size() == 1 || wavelength <= wavelengths.front()) return {0, 0};
  if (wavelength >= wavelengths.back()) return {wavelengths.size() - 2, 1};
  const auto above = std::upper_bound(wavelengths.begin(), wavelengths.end(), wavelength);
  const std::size_t first = static_cast<std::size_t>(above - wavelengths.begin()) - 1;
  return {first, (wavelength - wavelengths[first]) / (wavelengths[first + 1] - wavelengths[first])};
}

glm::dvec3 positive(const glm::dvec3& rgb) {
  return glm::max(rgb, glm::dvec3(0));
}

}  // namespace

double Spectrum::at(double wavelength) const {
  const auto [first, t] = locate(wavelengths, wavelength);
  return t == 0 ? values[first] : (1 - t) * values[first] + t * values[first + 1];
}

glm::dvec3 colour_matching(double nm) {
  return {1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) -
              0.065 * lobe(nm, 501.1, 20.4, 26.2),
          0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
          1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8)};
}

glm::dvec3 rgb_of_xyz(const glm::dvec3& xyz) {
  return {3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
          -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
          0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
}

double luminance(const glm::dvec3& rgb) {
  return 0.2126729 * rgb.x + 0.7151522 * rgb.y + 0.0721750 * rgb.z;
}

glm::dvec3 rgb_of_emission(const Spectrum& spectrum) {
  return positive(emission([&](double nm) { return spectrum.at(nm); }));
}

glm::dvec3 rgb_of_reflectance(const Spectrum& spectrum) {
  return positive(emission([&](double nm) { return spectrum.at(nm); }) / white());
}

std::vector<glm::dvec3> reflectance_weights(const std::vector<double>& wavelengths) {
  std::vector<glm::dvec3> weights(wavelengths.size(), glm::dvec3(0));
  const glm::dvec3 scale = 1.0 / (white() * integral_of_one().y);
  for (int nm = kFirst; nm <= kLast; ++nm) {
    const auto [first, t] = locate(wavelengths, nm);
    const glm::dvec3 rgb = rgb_of_xyz(colour_matching(nm)) * scale;
    weights[first] += (1 - t) * rgb;
    if (t > 0) weights[first + 1] += t * rgb;
  }
  return weights;
}

double blackbody(double wavelength, double kelvin) {
  constexpr double kSecondRadiation = 1.438776877e7;  // nm K
  constexpr double kWien = 2.897771955e6;             // nm K
  const auto planck = [&](double nm) {
    return std::pow(nm, -5) / std::expm1(kSecondRadiation / (nm * kelvin));
  };
  return planck(wavelength) / planck(kWien / kelvin);
}

glm::dvec3 rgb_of_blackbody(double kelvin) {
  return positive(emission([&](double nm) { return blackbody(nm, kelvin); }));
}

std::optional<glm::dvec3> rgb_of_illuminant(const std::string& name) {
  const std::string prefix = "stdillum-";
  if (!name.starts_with(prefix)) return std::nullopt;
  const std::string kind = name.substr(prefix.size());
  glm::dvec3 rgb;
  double number = 0;
  if (kind == "A") {
    rgb = rgb_of_blackbody(2856);
  } else if (kind == "D65") {
    rgb = glm::dvec3(1);
  } else if (kind.size() > 1 && kind[0] == 'D' && parse_number(kind.substr(1), number) == NumberText::ok &&
             number >= 40 && number <= 250) {
    // The number is the temperature / 100 of the day when the second radiation constant was 1.4380e-2.
    const double t = number * 100 * 1.438776877 / 1.4380;
    const double x = t <= 7000 ? -4.6070e9 / (t * t * t) + 2.9678e6 / (t * t) + 0.09911e3 / t + 0.244063
                               : -2.0064e9 / (t * t * t) + 1.9018e6 / (t * t) + 0.24748e3 / t + 0.237040;
    const double y = -3 * x * x + 2.870 * x - 0.275;
    rgb = positive(rgb_of_xyz({x / y, 1, (1 - x - y) / y}));
  } else {
    return std::nullopt;
  }
  return rgb / luminance(rgb);
}

}  // namespace capcon
