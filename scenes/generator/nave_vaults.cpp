#include <cmath>

#include "generator/nave.h"
#include "generator/nave_plan.h"
#include "generator/profiles.h"
#include "generator/solids.h"
#include "generator/vault.h"

namespace capcon::scenes::church {

namespace {
/// Webs, diagonals, wall ribs and boss of a bay, z = 0 at the springing.
Model vault_bay(double half_width, double half, double width, double depth, int segments) {
  Model model;
  model.add("web", groin_vault(kBay, half_width, half, segments / 2));
  const auto height = [&](double t) { return pointed_height(1 - std::abs(2 * t - 1), half); };
  Mesh ribs;
  const double w = half_width;
  ribs.append(rib({0, -w}, {kBay, w}, height, width, depth, segments));
  ribs.append(rib({0, w}, {kBay, -w}, height, width, depth, 28));
  for (const double y : {-w, w})
    ribs.append(rib({0, y}, {kBay, y}, height, 1.1 * width, 0.5 * depth, segments - 4));
  ribs.append(vault_boss(1.4 * width), translate(kBay / 2, 0, pointed_height(1, half) - 0.6 * depth));
  model.add("stone", ribs);
  return model;
}

Model transverse_rib(double half_width, double half, double width, double depth, int segments) {
  Model model;
  const auto height = [&](double t) { return pointed_height(1 - std::abs(2 * t - 1), half); };
  model.add("stone", rib({0, -half_width}, {0, half_width}, height, width, depth, segments));
  return model;
}
}  // namespace

void add_vaults(Assembly& scene) {
  scene.define("vault", vault_bay(kFace, kFace, 0.26, 0.26, 16));
  scene.define("vault-rib", transverse_rib(kFace, kFace, 0.42, 0.34, 20));
  const double aisle_half = 0.5 * (kAisle - kFace - kThick), middle = 0.5 * (kAisle + kFace + kThick);
  scene.define("aisle-vault", vault_bay(aisle_half, 1.95, 0.18, 0.18, 10));
  scene.define("aisle-rib", transverse_rib(aisle_half, 1.95, 0.3, 0.24, 10));
  for (int i = 0; i <= kBays; ++i) {
    scene.place("vault-rib", translate(kBay * i, 0, kTriforiumHead));
    if (i < kBays) scene.place("vault", translate(kBay * i, 0, kTriforiumHead));
    for (const double y : {-middle, middle}) {
      scene.place("aisle-rib", translate(kBay * i, y, kCapital));
      if (i < kBays) scene.place("aisle-vault", translate(kBay * i, y, kCapital));
    }
  }
}

}  // namespace capcon::scenes::church
