#include <cmath>

#include "generator/courtyard.h"
#include "generator/courtyard_plan.h"
#include "generator/profiles.h"
#include "generator/solids.h"

namespace capcon::scenes::court {

namespace {
constexpr double kStep = 0.335;   // between rows of tiles, along the slope
constexpr double kCourse = 0.24;  // between columns of tiles
constexpr int kVariants = 3;
const double kSlope = std::tan(kRoofDegrees * kPi / 180);
const double kCosine = std::cos(kRoofDegrees * kPi / 180);
const double kLength = (kWalk + kOverhang) / kCosine;
const int kRows = static_cast<int>(std::floor(kLength / kStep));

/// A half pipe from y = 0 (radius r0) to `length` (radius r1), lifted by `rise` at y = 0: crown up for a
/// cover tile.
Mesh half_pipe(double r0, double r1, double length, double rise, bool cover) {
  constexpr int kSegments = 8;
  constexpr double kThick = 0.013;
  std::vector<Vec2> section;
  const double from = cover ? 0.0 : kPi + 0.15, turn = cover ? kPi : kPi - 0.3;
  for (int i = 0; i <= kSegments; ++i) {
    const double a = from + turn * i / kSegments;
    section.emplace_back(std::cos(a), std::sin(a));
  }
  Mesh mesh;
  for (const double thick : {0.0, -kThick}) {
    for (int end = 0; end < 2; ++end) {
      const double r = (end ? r1 : r0) + thick;
      for (const Vec2& s : section) mesh.vertex(Vec3(r * s.x, end ? length : 0, r * s.y + (end ? 0 : rise)));
    }
  }
  const std::uint32_t n = kSegments + 1;
  for (std::uint32_t i = 0; i + 1 < n; ++i) {
    mesh.quad(i + 1, i, n + i, n + i + 1);                          // outer side
    mesh.quad(2 * n + i, 2 * n + i + 1, 3 * n + i + 1, 3 * n + i);  // inner side
    mesh.quad(i, i + 1, 2 * n + i + 1, 2 * n + i);                  // the lower end
  }
  mesh.quad(0u, 2 * n, 3 * n, n);
  mesh.quad(2 * n - 1, 4 * n - 1, 3 * n - 1, n - 1);
  return mesh;
}

/// One column of tiles: `first` rows from the eaves are missing (they begin at a valley).
Model course(int first, int variant) {
  const Dice dice(10 + variant);
  Model model;
  const Mesh cover = half_pipe(0.092, 0.072, 0.43, 0.026, true),
             pan = half_pipe(0.088, 0.105, 0.43, 0.024, false);
  for (int row = first; row < kRows; ++row) {
    const auto jitter = [&](int k, double amount) { return dice.between(-amount, amount, row, k); };
    const double y = row * kStep;
    model.add("tile", pan,
              translate(jitter(0, 0.002), y + jitter(1, 0.008), 0.118) * rotate_z(jitter(2, 0.5)));
    model.add("tile", cover,
              translate(kCourse / 2 + jitter(3, 0.004), y + jitter(4, 0.012), 0.098 + jitter(5, 0.003)) *
                  rotate_z(jitter(6, 1.4)) * rotate_y(jitter(7, 2.5)));
  }
  return model;
}

/// Boards and rafters under the tiles, cut at 45 degrees where two roofs meet.
Model carpentry(Side side) {
  Model model;
  const double half = half_length(side), low = -kOverhang + 0.05, high = kWalk + 0.05;
  const bool west_valley = side != Side::south, east_valley = side != Side::north;
  const auto z = [&](double y) { return kEaves + (y + kOverhang) * kSlope; };
  // The ends in the side's frame: a valley's diagonal, or the east wall.
  const auto left = [&](double y) { return west_valley ? -half - y : -kEastFace - 0.05; };
  const auto right = [&](double y) { return east_valley ? half + y : kEastFace + 0.05; };
  for (const double lift : {0.0, 0.022}) {
    const Vec3 a(left(low), low, z(low) + lift), b(right(low), low, z(low) + lift);
    const Vec3 c(right(high), high, z(high) + lift), d(left(high), high, z(high) + lift);
    Mesh deck;
    lift > 0 ? deck.quad(a, b, c, d) : deck.quad(d, c, b, a);
    if (lift > 0) deck.quad(a - Vec3(0, 0, 0.022), b - Vec3(0, 0, 0.022), b, a);
    model.add("timber", deck);
  }
  const double reach = half + kWalk;
  const int count = static_cast<int>(2 * reach / 0.56);
  for (int i = 0; i < count; ++i) {
    const double x = -reach + 0.28 + 0.56 * i;
    double foot = low - 0.06;
    if (x < -half - foot - 0.1 || x > half + foot + 0.1) foot = std::abs(x) - half + 0.12;
    if ((!west_valley && x < -kEastFace) || (!east_valley && x > kEastFace) || foot > high - 0.2) continue;
    const Mesh beam =
        bevelled_box(Vec3(x - 0.05, foot / kCosine, -0.15), Vec3(x + 0.05, high / kCosine, -0.002), 0.006);
    model.add("timber", beam, translate(0, 0, kEaves + kOverhang * kSlope) * rotate_x(kRoofDegrees));
  }
  return model;
}
}  // namespace

void add_roofs(Assembly& scene) {
  for (int first = 0; first < kRows - 1; ++first) {
    for (int variant = 0; variant < (first == 0 ? kVariants : 1); ++variant) {
      scene.define("tiles-" + std::to_string(first) + "-" + std::to_string(variant),
                   course(first, variant + 3 * first));
    }
  }
  int number = 0;
  for (const Side side : kSides) {
    const double corner = half_length(side) - kOverhang, end = half_length(side) + kWalk;
    const Matrix slope = side_frame(side) * translate(0, -kOverhang, kEaves + 0.02) * rotate_x(kRoofDegrees);
    const int count = static_cast<int>(2 * end / kCourse);
    for (int i = 0; i < count; ++i, ++number) {
      const double x = -end + kCourse * (i + 0.5);
      if ((side == Side::north && x > kEastFace - 0.2) || (side == Side::south && x < -kEastFace + 0.2))
        continue;
      const double beyond = std::max(0.0, std::abs(x) - corner + 0.06);
      const int first = static_cast<int>(std::ceil(beyond / kCosine / kStep));
      if (first >= kRows - 1) continue;
      const int variant = first == 0 ? number * 7 % kVariants : 0;
      scene.place("tiles-" + std::to_string(first) + "-" + std::to_string(variant),
                  slope * translate(x, 0, 0));
    }
    scene.add(side == Side::north  ? "carpentry-north"
              : side == Side::west ? "carpentry-west"
                                   : "carpentry-south",
              carpentry(side), side_frame(side));
  }
}

}  // namespace capcon::scenes::court
