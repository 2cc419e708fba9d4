#pragma once

#include <vector>

#include "stability/image_case.h"

namespace capcon::stability {

/// Scenes scaled by 1e-6 ... 1e6, moved by up to 1e6 of their size, seen from as far.
std::vector<ImageCase> place_cases();
/// Slivers, triangles without area, duplicates, coplanar and interpenetrating ones, huge beside tiny, rays in
/// planes.
std::vector<ImageCase> geometry_cases();
/// Occlusion radii, lights, environments, materials.
std::vector<ImageCase> integrand_cases();
/// Virtual lights in corners, and limits of the geometry term.
std::vector<ImageCase> virtual_light_cases();

}  // namespace capcon::stability
