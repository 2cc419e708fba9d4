#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "image/image.h"

namespace capcon {

/// How an image covers the sphere of directions in the light's own space, z up; u grows to the right of the
/// image, v downwards from its top row, both in [0, 1].
enum class SphereMap : std::uint8_t {
  lat_long,   ///< pbrt-v2 and v3: u = phi/2pi with phi = atan2(y, x) in [0, 2pi), v = theta/pi from +z
  octahedral  ///< pbrt-v4: equal areas; Clarberg, "Fast Equal-Area Mapping of the (Hemi)Sphere using SIMD",
              ///< JGT 13(3), 2008; +z at the centre, -z at the corners, +x to the right, +y to the bottom
};

/// Unit direction to image coordinates and back.
glm::dvec2 square_of_direction(SphereMap map, const glm::dvec3& direction);
glm::dvec3 direction_of_square(SphereMap map, const glm::dvec2& square);

/// Solid angle of a texel of row `y` of width x height texels; over the image they sum to 4 pi.
double texel_solid_angle(SphereMap map, int width, int height, int y);

/// One texel as RGB, with what is negative or not finite read as 0. Beyond the edges the neighbour on the
/// sphere (of lat-long rows at the poles, the same texel), up to one image away.
glm::dvec3 sphere_texel(SphereMap map, const Image& image, int x, int y);

/// The image towards a unit direction, bilinear between texel centres.
glm::dvec3 sphere_lookup(SphereMap map, const Image& image, const glm::dvec3& direction);

}  // namespace capcon
