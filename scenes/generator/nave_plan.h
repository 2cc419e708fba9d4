#pragma once

#include "generator/mesh.h"

namespace capcon::scenes::church {

// The nave runs along x from the west wall (x = 0); y = 0 is its middle. Metres.
constexpr int kBays = 6;
constexpr double kBay = 4.6;
constexpr double kLength = kBays * kBay;
constexpr double kFace = 4.05;    // the arcade walls' inner faces, |y|
constexpr double kThick = 0.9;    // of the arcade walls
constexpr double kAisle = 8.5;    // the aisles' outer walls, |y|
constexpr double kCapital = 4.6;  // top of the piers: the arcade and the aisle vaults spring
constexpr double kArcadeHalf = 1.75;
constexpr double kArcadeHead = 7.9;
constexpr double kTriforiumHead = 9.9;  // the high vault springs
constexpr double kHead = 16.2;
constexpr double kAisleHead = 8.0;
constexpr double kApse = kLength + 0.6;  // x of the apse's centre
constexpr double kPlatform = 0.51;       // its floor above the nave's

/// Frame of an arcade wall: x along it, its face at y = 0, the nave at y < 0, the aisle behind y = kThick.
inline Matrix wall_frame(bool north) {
  return north ? translate(0, kFace, 0) : translate(kLength, 0, 0) * rotate_z(180) * translate(0, kFace, 0);
}
inline double bay_centre(int bay) {
  return kBay * (bay + 0.5);
}

}  // namespace capcon::scenes::church
