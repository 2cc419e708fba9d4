#include "shading/roughness.h"

#include <algorithm>
#include <cmath>

namespace capcon {

double alpha_of_v2(double roughness) {
  return std::clamp(std::sqrt(2 * roughness / (1 + 2 * roughness)), kSmallestAlpha, 1.0);
}

double alpha_of_v3(double roughness) {
  const double x = std::log(std::max(roughness, 1e-3));
  const double alpha = 1.62142 + x * (0.819955 + x * (0.1734 + x * (0.0171201 + x * 0.000640711)));
  return std::clamp(alpha, kSmallestAlpha, 1.0);
}

double alpha_of_v4(double roughness) {
  return std::clamp(std::sqrt(roughness), kSmallestAlpha, 1.0);
}

}  // namespace capcon
