#include <algorithm>
#include <cmath>

#include "shading/material.h"

namespace capcon {

double fresnel(double cosine, double eta, double k) {
  // Born and Wolf, "Principles of Optics", section 14.2: a + i b = sqrt((eta + i k)^2 - sin^2).
  const double c = std::clamp(cosine, 0.0, 1.0), c2 = c * c, s2 = 1 - c2;
  const double real = eta * eta - k * k - s2, imaginary = 2 * eta * k;
  const double modulus = std::hypot(real, imaginary);  // a^2 + b^2
  const double a = std::sqrt(std::max(0.0, (modulus + real) / 2));
  const double perpendicular = (modulus - 2 * a * c + c2) / (modulus + 2 * a * c + c2);
  if (s2 == 0) return perpendicular;
  const double t = c2 * modulus + s2 * s2, u = 2 * a * c * s2;
  const double ratio = t + u > 0 ? (t - u) / (t + u) : 1;
  return (perpendicular + perpendicular * ratio) / 2;
}

double inner_reflectance(double eta) {
  constexpr int kSteps = 4096;
  double outer = 0;
  for (int i = 0; i < kSteps; ++i) outer += fresnel(std::sqrt((i + 0.5) / kSteps), eta, 0) / kSteps;
  return 1 - (1 - outer) / (eta * eta);
}

}  // namespace capcon
