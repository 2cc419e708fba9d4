#pragma once

#include <array>

/// The colours of FLIP (image/flip.h): linear sRGB in [0, 1] on the one side, spaces of the eye on the other.
namespace capcon::flip_colour {

using Vector = std::array<double, 3>;

/// Y of XYZ, 1 for white.
double luminance(const Vector& rgb);
/// Linear RGB as CIELAB without its cube roots: the space in which the eye's blur is linear.
Vector to_opponents(const Vector& rgb);
Vector from_opponents(const Vector& opponents);
/// CIELAB of linear RGB, its chroma scaled by lightness: dark colours look less colourful (Hunt).
Vector to_hunt_lab(const Vector& rgb);
/// The distance of Abasi et al. for large differences, |dL| + |d(a, b)|, and FLIP's power 0.7 of it.
double colour_distance(const Vector& a, const Vector& b);
/// [0, most] to [0, 1], the first two fifths of it to [0, 0.95]; most is the distance of green and blue.
double redistributed(double distance);

}  // namespace capcon::flip_colour
