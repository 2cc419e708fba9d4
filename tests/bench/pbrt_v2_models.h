#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <string>

#include "base/file.h"

namespace capcon::bench {

/// A BRDF of directions in the local frame, z the normal.
using Model = std::function<glm::dvec3(const glm::dvec3& in, const glm::dvec3& out)>;

constexpr double kPi = 3.14159265358979323846;

/// pbrt-v2's Blinn distribution: (e + 2) / (2 pi) cos^e, e = 1 / roughness.
inline double blinn(double cosine, double roughness) {
  return (1 / roughness + 2) / (2 * kPi) * std::pow(cosine, 1 / roughness);
}

/// Its masking: long V-shaped cavities (Torrance and Sparrow 1967).
inline double cavities(const glm::dvec3& in, const glm::dvec3& out, const glm::dvec3& half) {
  const double along = glm::dot(out, half);
  return std::min(1.0, std::min(2 * half.z * out.z / along, 2 * half.z * in.z / along));
}

/// Its FresnelDielectric(1.5, 1), which takes light to come from the dense side: all is reflected beyond 41.8
/// degrees.
inline double fresnel_from_within(double cosine) {
  const double sine = 1.5 * std::sqrt(std::max(0.0, 1 - cosine * cosine));
  if (sine >= 1) return 1;
  const double beyond = std::sqrt(1 - sine * sine);
  const double parallel = (cosine - 1.5 * beyond) / (cosine + 1.5 * beyond),
               across = (1.5 * cosine - beyond) / (1.5 * cosine + beyond);
  return (parallel * parallel + across * across) / 2;
}

/// Its FresnelConductor.
inline double fresnel_of_metal(double c, double eta, double k) {
  const double square = eta * eta + k * k;
  const double parallel = (square * c * c - 2 * eta * c + 1) / (square * c * c + 2 * eta * c + 1),
               across = (square - 2 * eta * c + c * c) / (square + 2 * eta * c + c * c);
  return (parallel + across) / 2;
}

inline double facets(const glm::dvec3& in, const glm::dvec3& out, const glm::dvec3& half, double roughness) {
  return blinn(half.z, roughness) * cavities(in, out, half) / (4 * in.z * out.z);
}

inline Model metal_of_v2(const glm::dvec3& eta, const glm::dvec3& k, double roughness) {
  return [=](const glm::dvec3& in, const glm::dvec3& out) {
    const glm::dvec3 half = glm::normalize(in + out);
    const double c = glm::dot(in, half);
    const glm::dvec3 f(fresnel_of_metal(c, eta.x, k.x), fresnel_of_metal(c, eta.y, k.y),
                       fresnel_of_metal(c, eta.z, k.z));
    return f * facets(in, out, half, roughness);
  };
}

inline Model plastic_of_v2(const glm::dvec3& kd, const glm::dvec3& ks, double roughness) {
  return [=](const glm::dvec3& in, const glm::dvec3& out) {
    const glm::dvec3 half = glm::normalize(in + out);
    return kd / kPi + ks * fresnel_from_within(glm::dot(in, half)) * facets(in, out, half, roughness);
  };
}

inline Model substrate_of_v2(const glm::dvec3& kd, const glm::dvec3& ks, double roughness) {
  return [=](const glm::dvec3& in, const glm::dvec3& out) {
    const glm::dvec3 half = glm::normalize(in + out);
    const double c = glm::dot(in, half);
    const auto base = [](double cosine) { return 1 - std::pow(1 - cosine / 2, 5); };
    const glm::dvec3 schlick = ks + std::pow(1 - c, 5) * (1.0 - ks);
    return 28 / (23 * kPi) * kd * (1.0 - ks) * base(in.z) * base(out.z) +
           blinn(half.z, roughness) / (4 * c * std::max(in.z, out.z)) * schlick;
  };
}

/// The model as a MERL binary, finer than the database's; -1 where a direction is below the surface.
inline void write_merl(const std::filesystem::path& path, const Model& model) {
  constexpr int kSize[3] = {192, 128, 64};
  constexpr std::size_t kCells = std::size_t(kSize[0]) * kSize[1] * kSize[2];
  constexpr double kScale[3] = {1500, 1500 / 1.15, 1500 / 1.66};
  std::string bytes(12 + 24 * kCells, '\0');
  std::memcpy(bytes.data(), kSize, 12);
  for (std::size_t cell = 0; cell < kCells; ++cell) {
    const auto middle = [](std::size_t i, int count) { return (static_cast<double>(i) + 0.5) / count; };
    const std::size_t row = cell / kSize[2];
    const double t = middle(row / kSize[1], kSize[0]), theta = t * t * kPi / 2,
                 difference = middle(row % kSize[1], kSize[1]) * kPi / 2,
                 azimuth = middle(cell % kSize[2], kSize[2]) * kPi;
    const glm::dvec3 half(std::sin(theta), 0, std::cos(theta)), tangent(std::cos(theta), 0, -std::sin(theta));
    const glm::dvec3 side =
        std::sin(difference) * (std::cos(azimuth) * tangent + std::sin(azimuth) * glm::dvec3(0, 1, 0));
    const glm::dvec3 in = std::cos(difference) * half + side, out = std::cos(difference) * half - side;
    const glm::dvec3 value = in.z > 0 && out.z > 0 ? model(in, out) : glm::dvec3(-1);
    for (int c = 0; c < 3; ++c) {
      const double scaled = value[c] * kScale[c];
      std::memcpy(bytes.data() + 12 + 8 * (c * kCells + cell), &scaled, 8);
    }
  }
  write_file(path, bytes);
}

}  // namespace capcon::bench
