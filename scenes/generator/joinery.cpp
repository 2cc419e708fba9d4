#include "generator/joinery.h"

#include <cmath>

#include "generator/profiles.h"
#include "generator/solids.h"

namespace capcon::scenes {

namespace {
constexpr double kRecess = 0.2;  // of doors and windows behind the wall's face

std::vector<Vec2> frame_section() {
  return Profile(0.15, -0.01)
      .to(0.15, 0.03)
      .by(-0.015, 0.015)
      .by(-0.05, 0)
      .by(-0.01, -0.015)
      .by(-0.06, 0)
      .by(-0.015, -0.01)
      .by(-0.02, -0.02)
      .by(0, -0.02)
      .points();
}

/// A leaf of a door with six raised panels, its face at y = 0 towards -y.
Mesh door_leaf(double x0, double x1, double z0, double z1) {
  Mesh mesh = box(Vec3(x0, 0, z0), Vec3(x1, 0.06, z1), kSouth);
  const double rail = 0.09, middle = 0.5 * (x0 + x1), height = (z1 - z0 - 4 * rail) / 3;
  for (int row = 0; row < 3; ++row) {
    const double z = z0 + rail + row * (height + rail);
    for (const auto& [a, b] :
         {std::pair(x0 + rail, middle - rail / 2), std::pair(middle + rail / 2, x1 - rail)}) {
      mesh.append(bevelled_box(Vec3(a, -0.022, z), Vec3(b, 0.02, z + height), 0.018));
    }
  }
  return mesh;
}

/// Glazing bars and panes of a window, at y = 0.
Model casement(double half, double z0, double z1) {
  Model model;
  model.add("glass", box(Vec3(-half - 0.05, 0.03, z0 - 0.05), Vec3(half + 0.05, 0.04, z1 + 0.4), kSouth));
  for (const double x : {-half + 0.035, 0.0, half - 0.035}) {
    model.add("timber",
              bevelled_box(Vec3(x - 0.04, -0.02, z0 - 0.02), Vec3(x + 0.04, 0.035, z1 + 0.3), 0.006));
  }
  const int rows = 4;
  for (int i = 0; i <= rows; ++i) {
    const double z = z0 + (z1 - z0) * i / rows;
    model.add("timber", bevelled_box(Vec3(-half, -0.012, z - 0.022), Vec3(half, 0.03, z + 0.022), 0.005));
  }
  return model;
}

/// A louvred shutter, folded back against the wall at y = 0: x from x0 to x1.
Mesh shutter(double x0, double x1, double z0, double z1) {
  Mesh mesh;
  for (const double x : {x0 + 0.03, x1 - 0.03})
    mesh.append(bevelled_box(Vec3(x - 0.03, -0.06, z0), Vec3(x + 0.03, -0.02, z1), 0.004));
  for (const double z : {z0 + 0.035, 0.5 * (z0 + z1), z1 - 0.035}) {
    mesh.append(
        bevelled_box(Vec3(x0 + 0.055, -0.058, z - 0.035), Vec3(x1 - 0.055, -0.022, z + 0.035), 0.004));
  }
  const Mesh slat =
      box(Vec3(x0 + 0.055, -0.022, -0.003), Vec3(x1 - 0.055, 0.022, 0.003), kAllFaces & ~kWest & ~kEast);
  for (double z = z0 + 0.1; z < z1 - 0.08; z += 0.045) {
    if (std::abs(z - 0.5 * (z0 + z1)) > 0.05) mesh.append(slat, translate(0, -0.04, z) * rotate_x(35));
  }
  return mesh;
}
}  // namespace

Model door(const Opening& o) {
  Model model;
  model.add("stone", archivolt(o, frame_section(), true));
  const double top = o.springing + 0.45;
  model.add("timber", door_leaf(-o.half_width - 0.02, -0.004, o.sill + 0.01, top), translate(0, kRecess, 0));
  model.add("timber", door_leaf(0.004, o.half_width + 0.02, o.sill + 0.01, top), translate(0, kRecess, 0));
  model.add("stone", bevelled_box(Vec3(-o.half_width - 0.16, -0.12, o.sill - 0.1),
                                  Vec3(o.half_width + 0.16, kRecess + 0.05, o.sill + 0.02), 0.01));
  return model;
}

Model window(const Opening& o, bool shutters) {
  Model model;
  model.add("stone", archivolt(o, frame_section(), true));
  model.add(casement(o.half_width, o.sill, o.springing), translate(0, kRecess, 0));
  model.add("stone", bevelled_box(Vec3(-o.half_width - 0.2, -0.09, o.sill - 0.09),
                                  Vec3(o.half_width + 0.2, kRecess + 0.02, o.sill + 0.012), 0.012));
  if (shutters) {
    const double a = o.half_width + 0.17, b = a + o.half_width;
    model.add("shutter", shutter(a, b, o.sill + 0.02, o.springing + 0.02));
    model.add("shutter", shutter(-b, -a, o.sill + 0.02, o.springing + 0.02));
  }
  return model;
}

}  // namespace capcon::scenes
