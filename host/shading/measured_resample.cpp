#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <optional>

#include "base/parallel.h"
#include "shading/measured_brdf.h"

namespace capcon {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kH = MeasuredBrdf::kHalf, kD = MeasuredBrdf::kDifference, kA = MeasuredBrdf::kAzimuth;

struct Angles {
  double half, difference, azimuth;  ///< azimuth folded into [0, pi/2]
};

Angles angles_of(const glm::dvec3& in, const glm::dvec3& out) {
  const glm::dvec3 half = glm::normalize(in + out);
  const double ring = std::hypot(half.x, half.y);
  // The frame of the half vector: x along theta_h, y along phi_h.
  const double cosine = ring > 0 ? half.x / ring : 1, sine = ring > 0 ? half.y / ring : 0;
  const double x = glm::dot(in, glm::dvec3(half.z * cosine, half.z * sine, -ring));
  const double y = glm::dot(in, glm::dvec3(-sine, cosine, 0));
  return {std::atan2(ring, half.z), std::atan2(std::hypot(x, y), glm::dot(in, half)),
          std::atan2(std::abs(y), std::abs(x))};
}

/// The directions of half-difference angles.
std::pair<glm::dvec3, glm::dvec3> directions_of(const Angles& a) {
  const glm::dvec3 half(std::sin(a.half), 0, std::cos(a.half)),
      tangent(std::cos(a.half), 0, -std::sin(a.half));
  const glm::dvec3 side =
      std::sin(a.difference) * (std::cos(a.azimuth) * tangent + std::sin(a.azimuth) * glm::dvec3(0, 1, 0));
  return {std::cos(a.difference) * half + side, std::cos(a.difference) * half - side};
}

Angles node(int h, int d, int a) {
  const double t = static_cast<double>(h) / (kH - 1);
  return {t * t * kPi / 2, static_cast<double>(d) / (kD - 1) * kPi / 2,
          static_cast<double>(a) / (kA - 1) * kPi / 2};
}

int index_of(int h, int d, int a) {
  return (h * kD + d) * kA + a;
}

using Values = std::vector<std::optional<glm::dvec3>>;

/// Gives nodes without a value the mean of their neighbours that have one, ring by ring.
void fill(Values& values) {
  for (bool changed = true; changed;) {
    changed = false;
    const Values before = values;
    for (int h = 0; h < kH; ++h) {
      for (int d = 0; d < kD; ++d) {
        for (int a = 0; a < kA; ++a) {
          if (before[index_of(h, d, a)]) continue;
          glm::dvec3 sum(0);
          int count = 0;
          const auto add = [&](int hh, int dd, int aa) {
            if (hh < 0 || hh >= kH || dd < 0 || dd >= kD || aa < 0 || aa >= kA) return;
            const auto& neighbour = before[index_of(hh, dd, aa)];
            if (neighbour) sum += *neighbour, ++count;
          };
          add(h - 1, d, a), add(h + 1, d, a), add(h, d - 1, a), add(h, d + 1, a), add(h, d, a - 1),
              add(h, d, a + 1);
          if (count == 0) continue;
          values[index_of(h, d, a)] = sum / static_cast<double>(count);
          changed = true;
        }
      }
    }
  }
}

/// The table of `value`, which has nothing to say where nothing was measured. Nodes of which a direction is
/// below the horizon are not asked; those within rounding of it are.
template <typename Value>
MeasuredBrdf tabulate(const Value& value) {
  Values values(static_cast<std::size_t>(kH) * kD * kA);
  std::vector<int> asked(kH, 0), missing(kH, 0);
  parallel_for(kH, [&](std::size_t h) {
    for (int d = 0; d < kD; ++d) {
      for (int a = 0; a < kA; ++a) {
        const Angles angles = node(static_cast<int>(h), d, a);
        const auto [in, out] = directions_of(angles);
        if (in.z < -1e-9 || out.z < -1e-9) continue;
        ++asked[h];
        auto& cell = values[index_of(static_cast<int>(h), d, a)];
        cell = value(angles, in, out);
        if (!cell) ++missing[h];
      }
    }
  });
  MeasuredBrdf brdf;
  int holes = 0, all = 0;
  for (int h = 0; h < kH; ++h) holes += missing[h], all += asked[h];
  if (holes > 0) {
    brdf.remarks.push_back(
        fmt::format("{:.1f} % of its directions were not measured and take their neighbours' values",
                    std::max(0.1, 100.0 * holes / all)));
  }
  fill(values);
  brdf.values.reserve(values.size());
  for (const auto& cell : values) brdf.values.emplace_back(cell.value_or(glm::dvec3(0)));
  return brdf;
}

/// Marschner's coordinates of a pair of directions.
glm::dvec3 marschner(double theta_in, double theta_out, double turn) {
  double fold = std::fmod(std::abs(turn), 2 * kPi);
  if (fold > kPi) fold = 2 * kPi - fold;
  return {std::sin(theta_in) * std::sin(theta_out), fold / kPi, std::cos(theta_in) * std::cos(theta_out)};
}

}  // namespace

glm::dvec3 MeasuredBrdf::operator()(const glm::dvec3& in, const glm::dvec3& out) const {
  if (!(in.z > 0) || !(out.z > 0)) return glm::dvec3(0);
  const Angles angles = angles_of(in, out);
  const double positions[3] = {std::sqrt(angles.half / (kPi / 2)) * (kH - 1),
                               angles.difference / (kPi / 2) * (kD - 1),
                               angles.azimuth / (kPi / 2) * (kA - 1)};
  const int sizes[3] = {kH, kD, kA};
  int first[3];
  double t[3];
  for (int axis = 0; axis < 3; ++axis) {
    first[axis] = std::clamp(static_cast<int>(positions[axis]), 0, sizes[axis] - 2);
    t[axis] = std::clamp(positions[axis] - first[axis], 0.0, 1.0);
  }
  glm::dvec3 sum(0);
  for (int corner = 0; corner < 8; ++corner) {
    const int h = corner & 1, d = corner >> 1 & 1, a = corner >> 2;
    const double weight = (h ? t[0] : 1 - t[0]) * (d ? t[1] : 1 - t[1]) * (a ? t[2] : 1 - t[2]);
    sum += weight * glm::dvec3(values[index_of(first[0] + h, first[1] + d, first[2] + a)]);
  }
  return sum;
}

MeasuredBrdf resample(const CornellBrdf& measured) {
  struct Point {
    glm::dvec3 at, value;
  };
  std::vector<Point> points;
  for (const BrdfSample& s : measured.samples)
    points.push_back({marschner(s.theta_in, s.theta_out, s.phi_in - s.phi_out), s.value});
  const std::size_t wanted = std::min<std::size_t>(3, points.size());
  MeasuredBrdf brdf = tabulate([&](const Angles&, const glm::dvec3& in, const glm::dvec3& out) {
    const double theta_in = std::acos(std::clamp(in.z, 0.0, 1.0)),
                 theta_out = std::acos(std::clamp(out.z, 0.0, 1.0));
    const double turn = std::atan2(in.y, in.x) - std::atan2(out.y, out.x);
    const glm::dvec3 at = marschner(theta_in, theta_out, turn);
    std::vector<double> distances(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const glm::dvec3 step = points[i].at - at;
      distances[i] = glm::dot(step, step);
    }
    for (double radius = 0.001;; radius *= 2) {
      std::size_t found = 0;
      for (const double distance : distances) found += distance <= radius;
      if (found < wanted) continue;  // ends: no two points are farther apart than sqrt(3)
      glm::dvec3 sum(0);
      double weights = 0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (distances[i] > radius) continue;
        const double weight = std::exp(-100 * distances[i]);
        sum += weight * points[i].value;
        weights += weight;
      }
      return std::optional<glm::dvec3>(sum / weights);
    }
  });
  if (measured.negatives > 0)
    brdf.remarks.push_back(fmt::format("{} of its values are negative and read as 0", measured.negatives));
  return brdf;
}

MeasuredBrdf resample(const MerlBrdf& measured) {
  const auto [halves, differences, azimuths] = measured.size;
  const auto cell = [&, differences = differences, azimuths = azimuths](int h, int d,
                                                                        int a) -> const glm::vec3& {
    return measured.values[(static_cast<std::size_t>(h) * differences + d) * azimuths + a];
  };
  return tabulate([&, halves = halves, differences = differences, azimuths = azimuths](
                      const Angles& angles, const glm::dvec3&,
                      const glm::dvec3&) -> std::optional<glm::dvec3> {
    // A value belongs to the middle of its bin.
    const double h = std::sqrt(angles.half / (kPi / 2)) * halves - 0.5;
    const double d = angles.difference / (kPi / 2) * differences - 0.5;
    glm::dvec3 sum(0);
    double weights = 0;
    for (const double turn : {angles.azimuth, kPi - angles.azimuth}) {  // what the table folds together
      const double a = turn / kPi * azimuths - 0.5;
      const double left[3] = {std::floor(h), std::floor(d), std::floor(a)};
      for (int corner = 0; corner < 8; ++corner) {
        const int up[3] = {corner & 1, corner >> 1 & 1, corner >> 2};
        const double weight = (up[0] ? h - left[0] : 1 - h + left[0]) *
                              (up[1] ? d - left[1] : 1 - d + left[1]) *
                              (up[2] ? a - left[2] : 1 - a + left[2]);
        const int hh = std::clamp(static_cast<int>(left[0]) + up[0], 0, halves - 1);
        const int dd = std::clamp(static_cast<int>(left[1]) + up[1], 0, differences - 1);
        const int aa = (static_cast<int>(left[2]) + up[2] + azimuths) % azimuths;  // phi_d + pi is the same
        const glm::vec3& value = cell(hh, dd, aa);
        if (value.r < 0) continue;
        sum += weight * glm::dvec3(value);
        weights += weight;
      }
    }
    if (!(weights > 1e-6)) return std::nullopt;
    return sum / weights;
  });
}

}  // namespace capcon
