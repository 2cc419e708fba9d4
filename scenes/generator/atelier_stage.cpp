#include <cmath>

#include "generator/atelier.h"
#include "generator/solids.h"
#include "generator/surfaces.h"

namespace capcon::scenes::studio {

namespace {
constexpr double kCrease = 40;
constexpr double kRise = 0.19, kRun = 0.3;
constexpr int kSteps = 5;

/// A bar of round edges along two posts and the half circle on them.
Mesh arch(double radius, double spring, double width, double depth) {
  std::vector<Frame> path;
  const Vec3 front(0, -1, 0);
  for (const double z : {-0.02, 0.5 * spring}) path.push_back({{-radius, 0, z}, {-1, 0, 0}, front});
  constexpr int kSpans = 48;
  for (int i = 0; i <= kSpans; ++i) {
    const double a = kPi * (1 - static_cast<double>(i) / kSpans);
    const Vec3 out(std::cos(a), 0, std::sin(a));
    path.push_back({Vec3(0, 0, spring) + radius * out, out, front});
  }
  for (const double z : {0.5 * spring, -0.02}) path.push_back({{radius, 0, z}, {1, 0, 0}, front});
  return sweep(rounded_rectangle(width, depth, 0.025, 4), true, path, Ends::open);
}
}  // namespace

void add_backdrop(Assembly& scene) {
  // Paper from the wall down over the floor, in one bend.
  constexpr double kBend = 1.3, kBack = 3.1, kTop = 6.5, kSide = 9;
  std::vector<Vec2> section = {{kBack, kTop}};
  constexpr int kSpans = 40;
  for (int i = 0; i <= kSpans; ++i) {
    const double a = kPi / 2 * i / kSpans;
    section.emplace_back(kBack - kBend + kBend * std::cos(a), kBend - kBend * std::sin(a));
  }
  section.emplace_back(-9, 0);
  Mesh paper = surface(
      [&](double u, double v) {
        const Vec2& p = section[static_cast<std::size_t>(std::lround(v * (section.size() - 1.0)))];
        return Vec3(kSide * (1 - 2 * u), p.x, p.y);
      },
      1, static_cast<int>(section.size()) - 1, false, false);
  Model model;
  model.add("paper", paper);
  scene.add("backdrop", model, Matrix(1), kCrease);
}

void add_arches(Assembly& scene) {
  Model model;
  model.add("cream", arch(1.13, 1.4, 0.2, 0.3));
  model.add("rose", arch(0.82, 1.4, 0.15, 0.22));
  scene.add("arches", model, translate(-0.35, 1.5, 0) * rotate_z(7), kCrease);
}

void add_stairs(Assembly& scene) {
  constexpr double kDepth = 1.1, kLanding = 1.15, kLength = kSteps * kRun + kLanding;
  Model model;
  for (int i = 0; i < kSteps; ++i) {
    const double x = i * kRun;
    model.add("brick",
              bevelled_box(Vec3(x, 0, i * kRise - 0.02), Vec3(kLength, kDepth, (i + 1) * kRise), 0.012));
  }
  // A rail on the side of the viewer: it draws its bars over the steps.
  constexpr double kHeight = 0.72, kInset = 0.09;
  Mesh iron;
  const auto step_top = [](double x) { return kRise * std::min<double>(kSteps, std::floor(x / kRun) + 1); };
  const auto rail_top = [](double x) { return kHeight + kRise * std::min<double>(kSteps, x / kRun + 0.5); };
  std::vector<Vec3> hand;
  for (int i = 0; i <= 14; ++i) {  // the volute at the foot
    const double a = 2 * kPi * 1.25 * (1 - i / 14.0), r = 0.035 + 0.085 * i / 14;
    hand.emplace_back(0.14 - r * std::sin(a), kInset, rail_top(0.14) - 0.12 + r * std::cos(a));
  }
  constexpr double kTurn = (kSteps - 0.5) * kRun;
  for (int i = 1; i <= 8; ++i) {
    const double x = 0.14 + (kTurn - 0.14) * i / 8;
    hand.emplace_back(x, kInset, rail_top(x));
  }
  hand.emplace_back(kTurn + 0.2, kInset, kHeight + kSteps * kRise);
  hand.emplace_back(kLength - 0.1, kInset, kHeight + kSteps * kRise);
  iron.append(tube(hand, std::vector<double>(hand.size(), 0.021), 12));
  for (int i = 0;; ++i) {
    const double x = 0.2 + 0.1 * i;
    if (x > kLength - 0.05) break;
    const double top = x < kTurn + 0.1 ? rail_top(x) : kHeight + kSteps * kRise;
    iron.append(tube({{x, kInset, step_top(x) - 0.01}, {x, kInset, top - 0.005}}, {0.0085, 0.0085}, 8));
  }
  model.add("iron", iron);
  scene.add("stairs", model, translate(0.85, 0.6, 0) * rotate_z(-7), kCrease);
}

}  // namespace capcon::scenes::studio
