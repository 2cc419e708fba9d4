#include <array>
#include <cmath>

#include "generator/columns.h"
#include "generator/profiles.h"
#include "generator/solids.h"
#include "generator/surfaces.h"
#include "generator/terrace.h"

namespace capcon::scenes::belvedere {

namespace {
constexpr double kCrease = 40, kRadius = 5.2, kRail = 4.6;

Vec3 on_circle(double radius, double degrees, double z) {
  const double a = degrees * kPi / 180;
  return {radius * std::cos(a), radius * std::sin(a), z};
}

/// A section (u outwards, v up) along the arc of the balustrade.
Mesh along_the_arc(const std::vector<Vec2>& section, double from, double to, int spans) {
  std::vector<Frame> path;
  for (int i = 0; i <= spans; ++i) {
    const double a = to + (from - to) * i / spans;  // clockwise: cross(out, up) is the way ahead
    path.push_back({on_circle(kRail, a, 0), on_circle(1, a, 0), Vec3(0, 0, 1)});
  }
  return sweep(section, true, path, Ends::capped);
}
}  // namespace

void add_floor(Assembly& scene) {
  const Dice dice(401);
  Model model;
  model.add("mortar", disc(kRadius, -0.008, 96));
  double inner = 0.3;
  int number = 0;
  for (int ring = 0; inner < kRadius - 0.05; ++ring) {
    const double depth = ring % 3 == 2 ? 0.2 : 0.5, outer = std::min(inner + depth, kRadius);
    const int count = static_cast<int>(std::lround(2 * kPi * outer / (ring % 3 == 2 ? 0.36 : 0.62)) / 2 * 2);
    constexpr double kGap = 0.004;
    for (int i = 0; i < count; ++i, ++number) {
      const double shift = ring % 2 * 0.5, a = 360.0 * (i + shift) / count,
                   b = 360.0 * (i + 1 + shift) / count;
      const auto gap = [&](double r) { return kGap / r * 180 / kPi; };
      const double z = dice.between(-0.0015, 0.0015, number);
      std::array<Vec3, 4> top = {
          on_circle(inner + kGap, a + gap(inner), z), on_circle(outer - kGap, a + gap(outer), z),
          on_circle(outer - kGap, b - gap(outer), z), on_circle(inner + kGap, b - gap(inner), z)};
      for (int k = 0; k < 4; ++k) top[k].z += dice.between(-0.001, 0.001, number, 1 + k);
      const bool dark = ring % 3 == 2 ? i % 2 == 0 : false;
      model.add(dark ? "slab-dark" : ring % 3 == 2 ? "slab-rose" : "slab", paving_stone(top, -0.03, 0.004));
    }
    inner = outer;
  }
  scene.add("floor", model);
}

void add_balustrade(Assembly& scene) {
  constexpr double kFrom = 4, kTo = 176, kFoot = 0.16, kHeight = 0.6;
  const std::vector<Vec2> foot = {{-0.13, -0.01}, {0.13, -0.01}, {0.13, 0.12},
                                  {0.1, kFoot},   {-0.1, kFoot}, {-0.13, 0.12}};
  Profile rail(-0.09, kFoot + kHeight);
  rail.to(0.09, kFoot + kHeight)
      .by(0.03, 0.03)
      .curve(0, 0.06, 0.6, 5)
      .by(-0.03, 0.03)
      .to(-0.09, kFoot + kHeight + 0.12);
  rail.by(-0.03, -0.03).curve(0, -0.06, 0.6, 5);
  Model model;
  model.add("stone", along_the_arc(foot, kFrom, kTo, 60));
  model.add("stone", along_the_arc(rail.points(), kFrom, kTo, 60));
  scene.add("rails", model, Matrix(1), kCrease);
  Model one;
  one.add("stone", baluster(kHeight));
  scene.define("baluster", one, kCrease);
  constexpr int kCount = 40;
  for (int i = 0; i < kCount; ++i) {
    const double a = kFrom + 1.5 + (kTo - kFrom - 3) * i / (kCount - 1);
    scene.place("baluster", translate(on_circle(kRail, a, kFoot - 0.004)) * rotate_z(a));
  }
}

void add_columns(Assembly& scene) {
  Model column;
  column.add("stone", fluted_column(3.3, 0.19));
  scene.define("column", column, kCrease);
  Model beams;
  beams.add("timber", bevelled_box(Vec3(-4, -0.09, 3.29), Vec3(4, 0.09, 3.52), 0.01));
  for (int i = 0; i < 17; ++i) {
    const double x = -3.84 + 0.48 * i;
    beams.add("timber", bevelled_box(Vec3(x - 0.035, -0.75, 3.515), Vec3(x + 0.035, 0.75, 3.65), 0.008));
  }
  scene.add("beams", beams, translate(0, 2.75, 0), kCrease);
  for (const double x : {-2.45, 2.45}) scene.place("column", translate(x, 2.75, 0));
}

}  // namespace capcon::scenes::belvedere
