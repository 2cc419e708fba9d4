#include "generator/wall.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "generator/solids.h"

namespace capcon::scenes {

std::vector<Vec2> arch_curve(Arch arch, double half_width, int segments) {
  if (arch == Arch::flat) return {{-half_width, 0}, {half_width, 0}};
  // Each half is an arc about a centre at (`reach` to the other side, `drop` below the springing).
  double reach = 0, drop = 0;
  if (arch == Arch::segmental) drop = 1.2 * half_width;
  if (arch == Arch::pointed) reach = 0.55 * half_width;
  const double radius = std::hypot(half_width + reach, drop);
  const double low = std::atan2(drop, half_width + reach), high = std::acos(reach / radius);
  std::vector<Vec2> curve(segments + 1);
  const int half = segments / 2;
  for (int i = 0; i <= half; ++i) {
    const double angle = low + (high - low) * i / half;
    const Vec2 p(radius * std::cos(angle) - reach, radius * std::sin(angle) - drop);
    curve[i] = Vec2(-p.x, p.y);
    curve[segments - i] = p;
  }
  curve[0] = {-half_width, 0};
  curve[segments] = {half_width, 0};
  curve[half].x = 0;
  return curve;
}

namespace {
/// The solid from a line's height up to the wall's head, front and back.
void add_panel(Mesh& mesh, const WallPlan& plan, Vec2 a, Vec2 b) {
  const double back = plan.thickness, high_a = plan.head + plan.slope * (a.x - plan.from),
               high_b = plan.head + plan.slope * (b.x - plan.from);
  if (plan.front) mesh.quad(Vec3(a.x, 0, a.y), Vec3(b.x, 0, b.y), Vec3(b.x, 0, high_b), Vec3(a.x, 0, high_a));
  if (plan.back) {
    mesh.quad(Vec3(b.x, back, b.y), Vec3(a.x, back, a.y), Vec3(a.x, back, high_a), Vec3(b.x, back, high_b));
  }
}

/// The inside of an opening: the polyline with the void on its right.
void add_reveal(Mesh& mesh, const WallPlan& plan, Vec2 a, Vec2 b) {
  const double back = plan.thickness;
  mesh.quad(Vec3(a.x, 0, a.y), Vec3(a.x, back, a.y), Vec3(b.x, back, b.y), Vec3(b.x, 0, b.y));
}
}  // namespace

Mesh wall(const WallPlan& plan) {
  Mesh mesh;
  const double back = plan.thickness;
  double at = plan.from;
  for (const Opening& o : plan.openings) {
    const double left = o.centre - o.half_width, right = o.centre + o.half_width;
    if (left > at) add_panel(mesh, plan, {at, plan.foot}, {left, plan.foot});
    const bool door = o.sill <= plan.foot;
    const double sill = door ? plan.foot : o.sill;
    if (!door) {
      WallPlan parapet = plan;
      parapet.head = sill;
      parapet.slope = 0;
      add_panel(mesh, parapet, {left, plan.foot}, {right, plan.foot});
      add_reveal(mesh, plan, {right, sill}, {left, sill});
    }
    const std::vector<Vec2> curve = arch_curve(o.arch, o.half_width, o.segments);
    if (o.springing > sill) {
      add_reveal(mesh, plan, {left, sill}, {left, o.springing});
      add_reveal(mesh, plan, {right, o.springing}, {right, sill});
    }
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
      const Vec2 a = curve[i] + Vec2(o.centre, o.springing), b = curve[i + 1] + Vec2(o.centre, o.springing);
      add_panel(mesh, plan, a, b);
      add_reveal(mesh, plan, a, b);
    }
    at = right;
  }
  if (plan.to > at) add_panel(mesh, plan, {at, plan.foot}, {plan.to, plan.foot});
  const double end = plan.head + plan.slope * (plan.to - plan.from);
  if (plan.top) {
    mesh.quad(Vec3(plan.from, 0, plan.head), Vec3(plan.to, 0, end), Vec3(plan.to, back, end),
              Vec3(plan.from, back, plan.head));
  }
  if (plan.ends) {
    mesh.append(box(Vec3(plan.from, 0, plan.foot), Vec3(plan.to, back, plan.head), kWest));
    mesh.append(box(Vec3(plan.from, 0, plan.foot), Vec3(plan.to, back, end), kEast));
  }
  return mesh;
}

Mesh archivolt(const Opening& o, const std::vector<Vec2>& section, bool jambs) {
  std::vector<Vec2> line = arch_curve(o.arch, o.half_width, o.segments);
  for (Vec2& p : line) p += Vec2(o.centre, o.springing);
  if (jambs) {
    line.insert(line.begin(), {o.centre - o.half_width, o.sill});
    line.emplace_back(o.centre + o.half_width, o.sill);
  }
  std::vector<Frame> frames;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const auto normal = [&](std::size_t k) {
      const Vec2 d = glm::normalize(line[k + 1] - line[k]);
      return Vec2(-d.y, d.x);
    };
    const Vec2 before = normal(i == 0 ? 0 : i - 1), after = normal(i + 1 == line.size() ? i - 1 : i);
    Vec2 mitre = (before + after) / (1 + glm::dot(before, after));
    if (!jambs && (i == 0 || i + 1 == line.size()) && o.arch != Arch::segmental) {
      mitre = Vec2(i == 0 ? -1 : 1, 0);  // stands level on its springing
    }
    frames.push_back({Vec3(line[i].x, 0, line[i].y), Vec3(mitre.x, 0, mitre.y), Vec3(0, -1, 0)});
  }
  return sweep(section, false, frames, jambs ? Ends::capped : Ends::open);
}

}  // namespace capcon::scenes
