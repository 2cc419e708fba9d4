#pragma once

#include <string>
#include <vector>

#include "render/geometry.h"
#include "render/light_data.h"
#include "render/material_data.h"

namespace capcon {

/// What direct lighting needs of a scene beyond its geometry, ready for the device.
struct ShadingData {
  MaterialData materials;
  LightData lights;
  DetailOptions details;
  std::vector<std::string> warnings;  ///< what of materials and lights is only approximated
};

/// Reads materials and lights; a scene read with ReadOptions::images. `everything`: normals and uvs even
/// where nothing needs them. InputError with its place for values that make no sense.
ShadingData make_shading_data(const Scene& scene, bool everything, const Placement& placement);

}  // namespace capcon
