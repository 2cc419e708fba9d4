#pragma once

#include "shading/light.h"

namespace capcon {

/// The geometry of a shape as a light's: kind, position, axes, normal, radius, triangles (added to `lights`),
/// area. Area 0 when nothing of it is left. `remark` gets a phrase when the form is approximated.
Light shape_of_light(const Scene& scene, const Shape& shape, Lights& lights, std::string& remark);

}  // namespace capcon
