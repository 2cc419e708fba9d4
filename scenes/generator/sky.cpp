#include "generator/sky.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/hash.h"

namespace capcon::scenes {

namespace {
double smoothstep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Noise on a lattice of whole numbers, smooth between them; from -1 to 1.
double noise(double x, double y, std::uint64_t octave) {
  const double fx = std::floor(x), fy = std::floor(y), u = smoothstep(0, 1, x - fx),
               v = smoothstep(0, 1, y - fy);
  const auto at = [&](int i, int j) {
    const auto cell = static_cast<std::uint64_t>(static_cast<std::int64_t>(fx) + i + 100000) * 1000003u +
                      static_cast<std::uint64_t>(static_cast<std::int64_t>(fy) + j + 100000);
    return 2 * uniform64(77, octave, cell) - 1;
  };
  return (at(0, 0) * (1 - u) + at(1, 0) * u) * (1 - v) + (at(0, 1) * (1 - u) + at(1, 1) * u) * v;
}

/// Cover of the clouds, 0 to 1: long banks of four octaves on a plane above.
double cloud(const Vec3& d) {
  if (d.z <= 0.02) return 0;
  double x = 1.1 * d.x / (d.z + 0.18) + 3, y = 1.9 * d.y / (d.z + 0.18) + 8, sum = 0, weight = 1;
  for (std::uint64_t octave = 0; octave < 5; ++octave) {
    sum += weight * noise(x, y, octave);
    const double turned = 1.9 * x + 0.6 * y + 5;
    y = 1.9 * y - 0.6 * x + 9;
    x = turned;
    weight *= 0.5;
  }
  return smoothstep(0.05, 0.85, sum) * smoothstep(0.02, 0.12, d.z);
}

/// To 12 bits of mantissa.
float rounded(double value) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  return static_cast<float>(std::ldexp(std::nearbyint(mantissa * 4096), exponent - 12));
}
}  // namespace

Vec3 Sky::background(const Vec3& d) const {
  const Vec3 to_sun = glm::normalize(sun);
  const double cosine = std::clamp(glm::dot(d, to_sun), -1.0, 1.0), away = std::acos(cosine) * 180 / kPi;
  const Vec3 warm(1.0, 0.66, 0.36);
  const Vec3 glow = warm * (1.1 * std::exp(-away / 8) + 0.75 * std::exp(-away / 30));
  const Vec3 zenith(0.09, 0.22, 0.54), low(0.66, 0.56, 0.52);
  if (d.z >= 0) {
    const double t = std::pow(1 - d.z, 3.5);
    Vec3 sky = glm::mix(zenith, low, t) + glow + 0.22 * warm * std::exp(-d.z / 0.06) * (0.6 + 0.4 * cosine);
    const double cover = cloud(d);
    const Vec3 white = Vec3(0.78, 0.76, 0.78) * (0.75 + 0.25 * cosine) + 0.9 * glow;
    return glm::mix(sky, white, 0.75 * cover);
  }
  // The sea: dark below, the horizon's haze far off, and the sun's way.
  const double depth = -d.z, far = std::exp(-depth / 0.05);
  const Vec3 water = glm::mix(Vec3(0.05, 0.11, 0.15), Vec3(0.14, 0.24, 0.30), std::exp(-depth / 0.35));
  const Vec3 flat = glm::normalize(Vec3(to_sun.x, to_sun.y, 0));
  const double aside = d.x * flat.y - d.y * flat.x, ahead = d.x * flat.x + d.y * flat.y;
  const double path = ahead > 0 ? std::exp(-aside * aside / (0.004 + 0.05 * depth)) * std::exp(-depth / 0.3) *
                                      smoothstep(0, 0.6, ahead)
                                : 0;
  return glm::mix(water, 0.8 * low, 0.7 * far) + warm * (0.75 * path);
}

double Sky::sun_share(const Vec3& d) const {
  const double away = std::acos(std::clamp(glm::dot(d, glm::normalize(sun)), -1.0, 1.0)) * 180 / kPi;
  return 1 - smoothstep(0.95 * sun_radius, 1.05 * sun_radius, away);
}

Image sky_map(const Sky& sky, int height) {
  Image image(2 * height, height, 3);
  const auto direction = [&](double x, double y) {
    const double phi = kPi * x / height, theta = kPi * y / height;
    return Vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
  };
  const double near = std::cos((sky.sun_radius * 1.05 + 360.0 / height) * kPi / 180);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Vec3 middle = direction(x + 0.5, y + 0.5);
      Vec3 value = sky.background(middle);
      if (glm::dot(middle, glm::normalize(sky.sun)) > near) {  // the sun's edge: 8 x 8 directions a texel
        double share = 0;
        for (int k = 0; k < 64; ++k)
          share += sky.sun_share(direction(x + (k % 8 + 0.5) / 8, y + (k / 8 + 0.5) / 8)) / 64;
        value += share * sky.sun_radiance;
      }
      for (int c = 0; c < 3; ++c) image.at(x, y, c) = rounded(value[c]);
    }
  }
  return image;
}

}  // namespace capcon::scenes
