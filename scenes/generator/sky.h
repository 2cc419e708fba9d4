#pragma once

#include "generator/mesh.h"
#include "image/image.h"

namespace capcon::scenes {

/// An evening sky over the sea, z up: a gradient from horizon to zenith, a glow about the sun, soft clouds,
/// the sun's way on the water. No model of an atmosphere, but stiff as one: the sun has 37 % of the light
/// on 1/5800 of the sphere.
struct Sky {
  Vec3 sun{0.31, 0.84, 0.36};         ///< towards the sun, not unit
  double sun_radius = 1.5;            ///< degrees; its edge is soft over a tenth of it
  Vec3 sun_radiance{1500, 980, 480};  ///< inside

  /// Linear sRGB towards a unit direction, the sun left out.
  Vec3 background(const Vec3& direction) const;
  /// Share of the sun's radiance there: 1 inside, 0 outside.
  double sun_share(const Vec3& direction) const;
};

/// The sky as a map of 2 height x height texels: pbrt's "mapname", top row at the zenith, u = phi/2pi
/// counter-clockwise from +x. Rounded to 12 bits, so that the file is small and the same wherever it is made.
Image sky_map(const Sky& sky, int height);

}  // namespace capcon::scenes
