#include "generator/tracery.h"

#include <cmath>

#include "generator/profiles.h"
#include "generator/solids.h"

namespace capcon::scenes {

namespace {
std::vector<Vec2> bar_section(double w) {
  return {{w, -0.05}, {w, 0.0}, {0.3 * w, 0.05}, {-0.3 * w, 0.05}, {-w, 0.0}, {-w, -0.05}};
}

Mesh pane(const Opening& o) {
  // A little larger than the opening, hidden in the reveal.
  return box(Vec3(o.centre - o.half_width - 0.04, 0.02, o.sill - 0.05),
             Vec3(o.centre + o.half_width + 0.04, 0.03, o.springing + 1.5 * o.half_width), kSouth);
}

Mesh ring(double x, double z, double radius, double w, int segments) {
  std::vector<Frame> frames;
  for (int k = 0; k < segments; ++k) {
    const double a =
        -2 * kPi * k / segments;  // clockwise as seen from the front, like an arch from left to right
    const Vec3 out(std::cos(a), 0, std::sin(a));
    frames.push_back({Vec3(x, 0, z) + radius * out, out, Vec3(0, -1, 0)});
  }
  return sweep(bar_section(w), false, frames, Ends::closed_loop);
}
}  // namespace

Model two_lights(const Opening& o, double recess) {
  constexpr double kBar = 0.07;
  Model model;
  Mesh bars;
  const double half = 0.5 * o.half_width, spring = o.springing - 0.35;
  for (const double side : {-1.0, 1.0}) {
    const Opening light{.centre = o.centre + side * half,
                        .half_width = half - 0.5 * kBar,
                        .sill = o.sill - 0.02,
                        .springing = spring,
                        .arch = Arch::pointed,
                        .segments = 10};
    bars.append(archivolt(light, bar_section(kBar), true));
  }
  const double radius = 0.4 * o.half_width;
  const double z = o.springing + 0.48 * o.half_width;
  bars.append(ring(o.centre, z, radius, kBar, 16));
  for (int k = 0; k < 4; ++k) {  // a quatrefoil
    const double a = kPi * k / 2 + kPi / 4;
    bars.append(
        ring(o.centre + 0.48 * radius * std::cos(a), z + 0.48 * radius * std::sin(a), 0.4 * radius, 0.03, 8));
  }
  model.add("stone", bars, translate(0, recess, 0));
  model.add("glass", pane(o), translate(0, recess + 0.03, 0));
  return model;
}

Model lancet(const Opening& o, double recess) {
  Model model;
  model.add("glass", pane(o), translate(0, recess + 0.03, 0));
  const double top = o.springing + 0.6 * o.half_width;
  for (int i = 1; o.sill + 0.55 * i < top; ++i) {
    const double z = o.sill + 0.55 * i;
    model.add("iron",
              box(Vec3(o.centre - o.half_width - 0.02, -0.015, z - 0.015),
                  Vec3(o.centre + o.half_width + 0.02, 0.015, z + 0.015), kSouth | kNorth | kTop | kBottom),
              translate(0, recess, 0));
  }
  model.add("iron",
            box(Vec3(o.centre - 0.015, 0.02, o.sill - 0.02),
                Vec3(o.centre + 0.015, 0.04, o.springing + 1.3 * o.half_width), kSouth | kWest | kEast),
            translate(0, recess, 0));
  return model;
}

Mesh hood(const Opening& o) {
  const std::vector<Vec2> section = Profile(0.2, -0.01)
                                        .by(0, 0.05)
                                        .by(-0.03, 0.03)
                                        .by(-0.05, 0)
                                        .curve(-0.06, -0.05, -0.3, 2)
                                        .by(-0.02, 0)
                                        .by(-0.03, -0.05)
                                        .points();
  return archivolt(o, section, true);
}

}  // namespace capcon::scenes
