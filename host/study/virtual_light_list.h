#pragma once

#include <string>

#include "shading/virtual_light.h"

namespace capcon {

/// The VPLs as CSV: a header line, then one line a VPL: set path bounce x y z nx ny nz flux_r flux_g flux_b.
/// World space, scene units, W; normals on the side that the path came from; all digits.
std::string virtual_lights_csv(const VirtualLights& lights);
/// The same as JSON: an array of objects {set, path, bounce, position, normal, flux}, one a line.
std::string virtual_lights_json(const VirtualLights& lights);

}  // namespace capcon
