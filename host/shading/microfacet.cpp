#include "shading/microfacet.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace capcon {

double ggx(double cosine, double alpha) {
  if (!(cosine > 0)) return 0;
  const double square = alpha * alpha, t = cosine * cosine * (square - 1) + 1;
  return square / (3.14159265358979323846 * t * t);
}

double ggx_masking(double cosine, double alpha) {
  const double c = std::abs(cosine), tangent2 = (1 - c * c) / (c * c);
  return c > 0 ? 2 / (1 + std::sqrt(1 + alpha * alpha * tangent2)) : 0;
}

double visible_normals_pdf(const glm::dvec3& in, const glm::dvec3& out, double alpha) {
  if (!(out.z > 0)) return 0;
  const glm::dvec3 half = glm::normalize(in + out);
  return ggx(half.z, alpha) * ggx_masking(out.z, alpha) / (4 * out.z);
}

}  // namespace capcon
