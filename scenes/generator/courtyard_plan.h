#pragma once

#include "generator/mesh.h"

namespace capcon::scenes::court {

// The court's plan: the axes of the arcades are the rectangle |x| <= kHalfX, |y| <= kHalfY. Arcades stand on
// the north, the west and the south; the east side is a wall with the stairs. Metres.
constexpr double kBay = 2.8;           // from column to column
constexpr double kHalfX = 2.5 * kBay;  // five bays
constexpr double kHalfY = 2 * kBay;    // four bays
constexpr double kWall = 0.44;         // thickness of the arcade
constexpr double kWalk = 3.2;          // from the arcade's axis to the outer wall
constexpr double kFloor = 0.15;        // the arcade's floor above the court's
constexpr double kSpringing = 2.9;     // of the lower arches
constexpr double kArchHalf = 1.13;
constexpr double kGallery = 4.62;  // floor of the upper gallery
constexpr double kRail = 0.95;     // of the balustrade above that
constexpr double kUpperSpringing = 6.65;
constexpr double kUpperArchHalf = 0.55;
constexpr double kEaves = 7.84;     // top of the rafters at the eaves
constexpr double kOverhang = 0.85;  // of the eaves before the arcade's axis
constexpr double kRoofDegrees = 20;
constexpr double kOuterHead = 10.9;  // top of the outer walls
constexpr double kEastFace = 6.9;    // the east wall faces west here

/// A side with an arcade. In its own frame x runs along the arcade, the arcade's axis is y = 0, the court
/// lies at y < 0 and the outer wall at y = kWalk.
enum class Side { north, west, south };
constexpr Side kSides[] = {Side::north, Side::west, Side::south};

inline Matrix side_frame(Side side) {
  switch (side) {
    case Side::north:
      return translate(0, kHalfY, 0);
    case Side::west:
      return rotate_z(90) * translate(0, kHalfX, 0);
    case Side::south:
      return rotate_z(180) * translate(0, kHalfY, 0);
  }
  return Matrix(1);
}
inline int bays(Side side) {
  return side == Side::west ? 4 : 5;
}
inline double half_length(Side side) {
  return side == Side::west ? kHalfY : kHalfX;
}
/// Middle of a bay in the side's frame.
inline double bay_centre(Side side, int bay) {
  return -half_length(side) + kBay * (bay + 0.5);
}

}  // namespace capcon::scenes::court
