#include "generator/columns.h"

#include <algorithm>
#include <cmath>

#include "generator/profiles.h"
#include "generator/solids.h"

namespace capcon::scenes {

namespace {
/// Torus, scotia, torus on a square plinth; `r` is the shaft's radius at its foot. Ends at 1.15 r.
Mesh attic_base(double r, int segments) {
  Mesh mesh = bevelled_box(Vec3(-1.45 * r, -1.45 * r, -0.02), Vec3(1.45 * r, 1.45 * r, 0.5 * r), 0.03 * r);
  Profile profile(1.2 * r, 0.49 * r);
  profile.to(1.28 * r, 0.5 * r).curve(0, 0.24 * r, 1, 7).by(-0.05 * r, 0).by(0, 0.04 * r);
  profile.curve(-0.06 * r, 0.14 * r, -0.7, 5).by(0, 0.03 * r).curve(0, 0.14 * r, 1, 6);
  profile.by(-0.03 * r, 0).by(0, 0.04 * r).curve(-0.09 * r, 0.1 * r, -0.35, 3);
  profile.to(0.97 * r, 1.26 * r);
  mesh.append(lathe(profile.points(), segments));
  return mesh;
}

/// Astragal, necking, echinus and abacus; from `foot` up to `head`, on a shaft of radius `r`.
Mesh capital(double foot, double head, double r, int segments) {
  const double h = head - foot;
  Profile profile(0.98 * r, foot - 0.002);
  profile.to(1.0 * r, foot).curve(0, 0.1 * h, 1, 5).by(0, 0.02 * h).curve(0.04 * r, 0.24 * h, -0.1, 3);
  profile.by(0.05 * r, 0).by(0, 0.04 * h).by(0.05 * r, 0).by(0, 0.04 * h);
  profile.curve(0.36 * r, 0.22 * h, 0.3, 7).by(0, 0.03 * h).to(0.9 * r, 0.72 * h + foot);
  Mesh mesh = lathe(profile.points(), segments);
  mesh.append(bevelled_box(Vec3(-1.6 * r, -1.6 * r, foot + 0.69 * h), Vec3(1.6 * r, 1.6 * r, foot + 0.9 * h),
                           0.04 * r));
  mesh.append(
      bevelled_box(Vec3(-1.72 * r, -1.72 * r, foot + 0.895 * h), Vec3(1.72 * r, 1.72 * r, head), 0.04 * r));
  return mesh;
}

/// Vignola's swelling: straight to a third of the height, then drawn in to 5/6 of the radius.
double entasis(double t) {
  const double u = std::max(0.0, (t - 1.0 / 3) * 1.5);
  return 1 - u * u / 6;
}
}  // namespace

Mesh fluted_column(double height, double radius) {
  constexpr int kFlutes = 20, kSegments = 5 * kFlutes, kRows = 12;
  const double foot = 1.24 * radius, head = height - 2.0 * radius;
  Mesh mesh = attic_base(radius, 40);
  std::vector<Vec2> profile;
  for (int i = 0; i <= kRows; ++i) {
    // Rows crowd at both ends, where the flutes run out.
    const double t = 0.5 - 0.5 * std::cos(kPi * i / kRows);
    profile.emplace_back(radius * entasis(t), foot + (head - foot) * t);
  }
  const auto flutes = [&](double angle, double z) {
    const double t = (z - foot) / (head - foot), end = std::min(t, 1 - t) / 0.05;
    const double depth = 0.085 * std::sqrt(std::clamp(end - 0.3, 0.0, 1.0));
    const double phase = angle * kFlutes / (2 * kPi), u = 2 * (phase - std::floor(phase + 0.5)) / 0.8;
    return std::abs(u) < 0.999 ? 1 - depth * std::sqrt(1 - u * u) : 1.0;
  };
  mesh.append(lathe(profile, kSegments, flutes));
  mesh.append(capital(head - 0.004, height, radius * entasis(1), 40));
  return mesh;
}

Mesh slender_column(double height, double radius) {
  constexpr int kSegments = 24, kRows = 6;
  const double foot = 1.24 * radius, head = height - 2.0 * radius;
  Mesh mesh = attic_base(radius, kSegments);
  std::vector<Vec2> profile;
  for (int i = 0; i <= kRows; ++i) {
    const double t = static_cast<double>(i) / kRows;
    profile.emplace_back(radius * entasis(t), foot + (head - foot) * t);
  }
  mesh.append(lathe(profile, kSegments));
  mesh.append(capital(head - 0.003, height, radius * entasis(1), kSegments));
  return mesh;
}

Mesh baluster(double height) {
  const double h = height;
  Mesh mesh = bevelled_box(Vec3(-0.065, -0.065, -0.01), Vec3(0.065, 0.065, 0.1 * h), 0.006);
  std::vector<Vec2> body = {{0.045, 0.09 * h}, {0.06, 0.12 * h}, {0.06, 0.15 * h}, {0.036, 0.18 * h}};
  const std::vector<Vec2> belly = smooth(
      {{0.036, 0.18 * h}, {0.062, 0.27 * h}, {0.068, 0.36 * h}, {0.045, 0.55 * h}, {0.03, 0.72 * h}}, 3);
  body.insert(body.end(), belly.begin() + 1, belly.end());
  body.insert(
      body.end(),
      {{0.045, 0.745 * h}, {0.045, 0.77 * h}, {0.034, 0.785 * h}, {0.055, 0.87 * h}, {0.055, 0.91 * h}});
  mesh.append(lathe(body, 16));
  mesh.append(bevelled_box(Vec3(-0.062, -0.062, 0.9 * h), Vec3(0.062, 0.062, h + 0.01), 0.006));
  return mesh;
}

Mesh square_pier(double height, double half) {
  Mesh mesh = box(Vec3(-half, -half, 0), Vec3(half, half, height), kUpright);
  const auto ring = [&](const Profile& profile) {
    mesh.append(moulding(
        profile.points(),
        {Vec3(half, -half, 0), Vec3(-half, -half, 0), Vec3(-half, half, 0), Vec3(half, half, 0)}, true));
  };
  Profile plinth(0.05, -0.02), impost(-0.01, height - 0.34);
  plinth.to(0.05, 0.22).curve(0, 0.06, 1, 5).by(-0.02, 0.01).curve(-0.024, 0.05, -0.3, 4).by(-0.016, 0.006);
  impost.by(0.03, 0)
      .curve(0, 0.04, 1, 4)
      .by(0, 0.06)
      .by(0.01, 0)
      .curve(0.05, 0.06, 0.4, 4)
      .by(0.02, 0)
      .by(0, 0.12);
  impost.by(-0.09, 0.02).by(-0.02, 0);
  ring(plinth);
  ring(impost);
  return mesh;
}

}  // namespace capcon::scenes
