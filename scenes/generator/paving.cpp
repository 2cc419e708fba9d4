#include <algorithm>
#include <array>
#include <cmath>

#include "generator/courtyard.h"
#include "generator/courtyard_plan.h"
#include "generator/profiles.h"
#include "generator/solids.h"

namespace capcon::scenes::court {

namespace {
std::array<Vec3, 4> rectangle(double x0, double y0, double x1, double y1, double z) {
  return {Vec3(x0, y0, z), Vec3(x1, y0, z), Vec3(x1, y1, z), Vec3(x0, y1, z)};
}

/// Large slabs in rows of uneven width, each a little tilted and worn; none under the fountain's steps.
Mesh court_slabs(double x0, double y0, double x1, double y1) {
  const Dice dice(1);
  Mesh mesh;
  int row = 0, stone = 0;
  for (double y = y0; y < y1 - 0.01; ++row) {
    double height = dice.between(0.42, 0.66, row);
    if (y1 - y - height < 0.4) height = y1 - y;
    for (double x = x0; x < x1 - 0.01; ++stone) {
      double width = dice.between(0.5, 1.05, 1000 + stone);
      if (x1 - x - width < 0.45) width = x1 - x;
      const double gap = 0.006;
      std::array<Vec3, 4> top = rectangle(x + gap, y + gap, x + width - gap, y + height - gap, 0);
      for (int k = 0; k < 4; ++k) {
        top[k].x += dice.between(-0.004, 0.004, 1000 + stone, 1 + k);
        top[k].y += dice.between(-0.004, 0.004, 1000 + stone, 5 + k);
      }
      // A plane, not four free corners: the top stays flat.
      const double level = dice.between(-0.006, 0.004, 1000 + stone, 9);
      const double sx = dice.between(-0.006, 0.006, 1000 + stone, 10),
                   sy = dice.between(-0.006, 0.006, 1000 + stone, 11);
      for (Vec3& p : top) p.z = level + sx * (p.x - x - width / 2) + sy * (p.y - y - height / 2);
      const Vec2 farthest(std::max(std::abs(x), std::abs(x + width)),
                          std::max(std::abs(y), std::abs(y + height)));
      const bool hidden = std::hypot(farthest.x, farthest.y) < 1.9;
      if (!hidden) mesh.append(paving_stone(top, -0.05, dice.between(0.006, 0.011, 1000 + stone, 12)));
      x += width;
    }
    y += height;
  }
  return mesh;
}

/// Square terracotta tiles from (x0, y0) to (x1, y1), top at z.
Mesh terracotta(double x0, double y0, double x1, double y1, double z, std::uint64_t stream) {
  const Dice dice(stream);
  Mesh mesh;
  const int nx = static_cast<int>(std::lround((x1 - x0) / 0.28)),
            ny = static_cast<int>(std::lround((y1 - y0) / 0.28));
  const double dx = (x1 - x0) / nx, dy = (y1 - y0) / ny, gap = 0.003;
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const int n = j * nx + i;
      std::array<Vec3, 4> top = rectangle(x0 + i * dx + gap, y0 + j * dy + gap, x0 + (i + 1) * dx - gap,
                                          y0 + (j + 1) * dy - gap, z - dice.between(0, 0.003, n));
      mesh.append(paving_stone(top, z - 0.02, 0.004));
    }
  }
  return mesh;
}

/// The arcade's edge: long stones that carry the columns.
Mesh kerb_stones(double length) {
  const Dice dice(2);
  Mesh mesh;
  const int count = static_cast<int>(std::lround(length / 0.93));
  for (int i = 0; i < count; ++i) {
    const double x0 = -length / 2 + length * i / count + 0.003,
                 x1 = -length / 2 + length * (i + 1) / count - 0.003;
    const double lean = dice.between(-0.006, 0.006, i);
    mesh.append(bevelled_box(Vec3(x0, -0.42 + lean, -0.06), Vec3(x1, 0.38, kFloor), 0.012));
  }
  return mesh;
}
}  // namespace

void add_paving(Assembly& scene) {
  Model ground;
  ground.add("earth", box(Vec3(-10.7, -9.3, -0.4), Vec3(7.4, 9.3, -0.035), kAllFaces));
  scene.add("ground", std::move(ground));
  Model slabs;
  slabs.add("paving", court_slabs(-kHalfX + 0.43, -kHalfY + 0.43, kEastFace, kHalfY - 0.43));
  scene.add("slabs", std::move(slabs));

  Model walk, corner, kerb, kerb_corner;
  const double inner = 0.385, outer = kWalk + 0.02;
  walk.add("terracotta", terracotta(-kBay / 2, inner, kBay / 2, outer, 0, 3));
  corner.add("terracotta", terracotta(inner, inner, outer, outer, 0, 4));
  corner.add("terracotta",
             terracotta(0.0, inner, inner, outer, 0, 5));  // the strips between the corner and the bays
  corner.add("terracotta", terracotta(inner, 0.0, outer, inner, 0, 6));
  // Under the tiles lies their bed; the gallery's bed is its ceiling's boards.
  Model bed;
  bed.add("earth", box(Vec3(-10.7, -9.3, -0.02), Vec3(kEastFace + 0.1, -kHalfY - 0.3, kFloor - 0.012), kTop));
  bed.add("earth", box(Vec3(-10.7, kHalfY + 0.3, -0.02), Vec3(kEastFace + 0.1, 9.3, kFloor - 0.012), kTop));
  bed.add("earth",
          box(Vec3(-10.7, -kHalfY - 0.3, -0.02), Vec3(-kHalfX - 0.3, kHalfY + 0.3, kFloor - 0.012), kTop));
  scene.add("walk-bed", std::move(bed));
  kerb.add("stone", kerb_stones(kBay));
  kerb_corner.add("stone", bevelled_box(Vec3(-0.44, -0.44, -0.06), Vec3(0.44, 0.44, kFloor + 0.006), 0.012));
  scene.define("walk", std::move(walk));
  scene.define("walk-corner", std::move(corner));
  scene.define("kerb", std::move(kerb));
  scene.define("kerb-corner", std::move(kerb_corner));
  for (const double x : {-kHalfX, kHalfX}) {
    for (const double y : {-kHalfY, kHalfY}) scene.place("kerb-corner", translate(x, y, 0));
  }
  for (const Side side : kSides) {
    const Matrix frame = side_frame(side);
    for (int bay = 0; bay < bays(side); ++bay) {
      const double u = bay_centre(side, bay);
      scene.place("kerb", frame * translate(u, 0, 0));
      for (const double z : {kFloor, kGallery}) scene.place("walk", frame * translate(u, 0, z));
    }
  }
  for (const double z : {kFloor, kGallery}) {
    scene.place("walk-corner", translate(-kHalfX, kHalfY, z) * rotate_z(90));
    scene.place("walk-corner", translate(-kHalfX, -kHalfY, z) * rotate_z(180));
  }
}

}  // namespace capcon::scenes::court
