#include "image/flip_colour.h"

#include <algorithm>
#include <cmath>

namespace capcon::flip_colour {
namespace {

// IEC 61966-2-1 (sRGB) to XYZ, and its white.
constexpr std::array<Vector, 3> kToXyz = {
    Vector{10135552. / 24577794, 8788810. / 24577794, 4435075. / 24577794},
    Vector{2613072. / 12288897, 8788810. / 12288897, 887015. / 12288897},
    Vector{1425312. / 73733382, 8788810. / 73733382, 70074185. / 73733382}};

Vector times(const std::array<Vector, 3>& m, const Vector& v) {
  Vector r{};
  for (int i = 0; i < 3; ++i) r[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return r;
}

std::array<Vector, 3> inverse(const std::array<Vector, 3>& m) {
  const auto minor = [&](int i, int j) {
    const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
    return m[a][c] * m[b][d] - m[a][d] * m[b][c];
  };
  const double determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  std::array<Vector, 3> r{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) r[i][j] = minor(j, i) / determinant;
  }
  return r;
}

/// XYZ over that of white.
Vector to_relative_xyz(const Vector& rgb) {
  static const Vector kWhite = times(kToXyz, {1, 1, 1});
  Vector v = times(kToXyz, rgb);
  for (int i = 0; i < 3; ++i) v[i] /= kWhite[i];
  return v;
}

}  // namespace

double luminance(const Vector& rgb) {
  return times(kToXyz, rgb)[1];
}

Vector to_opponents(const Vector& rgb) {
  const Vector v = to_relative_xyz(rgb);
  return {116 * v[1] - 16, 500 * (v[0] - v[1]), 200 * (v[1] - v[2])};
}

Vector from_opponents(const Vector& o) {
  static const Vector kWhite = times(kToXyz, {1, 1, 1});
  static const std::array<Vector, 3> kToRgb = inverse(kToXyz);
  const double y = (o[0] + 16) / 116;
  return times(kToRgb, {(y + o[1] / 500) * kWhite[0], y * kWhite[1], (y - o[2] / 200) * kWhite[2]});
}

Vector to_hunt_lab(const Vector& rgb) {
  Vector f = to_relative_xyz(rgb);
  for (double& t : f) {
    constexpr double kEdge = 6. / 29;
    t = t > kEdge * kEdge * kEdge ? std::cbrt(t) : t / (3 * kEdge * kEdge) + 4. / 29;
  }
  const double lightness = 116 * f[1] - 16;
  return {lightness, 0.01 * lightness * 500 * (f[0] - f[1]), 0.01 * lightness * 200 * (f[1] - f[2])};
}

double colour_distance(const Vector& a, const Vector& b) {
  constexpr double kPower = 0.7;
  return std::pow(std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]), kPower);
}

double redistributed(double distance) {
  static const double kMost = colour_distance(to_hunt_lab({0, 1, 0}), to_hunt_lab({0, 0, 1}));
  constexpr double kPart = 0.4, kShare = 0.95;
  const double turn = kPart * kMost;
  return distance < turn ? kShare / turn * distance
                         : kShare + (distance - turn) / (kMost - turn) * (1 - kShare);
}

}  // namespace capcon::flip_colour
