#pragma once

#include <string>

#include "generator/mesh.h"

namespace capcon::scenes {

/// BRDF in 1/sr of an invented lacquer at a wavelength in nm, between unit directions above the surface (z
/// its normal): a dark ground, flakes under a thin film whose colour goes from green to violet as the angle
/// between the directions opens, and a clear coat. Both lobes are inverse powers of the half vector's angle
/// (the "ABC" shape of Church and Takacs) with the denominator of Ashikhmin and Shirley (JGT 5(2), 2000).
/// Reciprocal, isotropic.
double lacquer(double wavelength, const Vec3& in, const Vec3& out);

/// A goniometer's table of it in the text format of the Cornell Program of Computer Graphics: 16 wavelengths,
/// pairs of 19 zenith angles (the steeper one first, since it is reciprocal), 25 azimuths that crowd about
/// the mirror direction.
std::string lacquer_table();

}  // namespace capcon::scenes
