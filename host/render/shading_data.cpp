#include "render/shading_data.h"

#include <algorithm>

#include "layout.h"

namespace capcon {
namespace {

template <class Has>
bool any_mesh(const Scene& scene, const Has& has) {
  return std::any_of(scene.meshes.begin(), scene.meshes.end(), has);
}

}  // namespace

ShadingData make_shading_data(const Scene& scene, bool everything, const Placement& placement) {
  const Materials materials = read_materials(scene);
  Lights lights = read_lights(scene);
  place_lights(lights, placement);
  ShadingData data{pack_materials(scene, materials), pack_lights(scene, lights), {}, materials.warnings};
  data.warnings.insert(data.warnings.end(), lights.warnings.begin(), lights.warnings.end());
  data.details.wanted = true;
  data.details.normals =
      everything || any_mesh(scene, [](const TriangleMesh& m) { return !m.normals.empty(); });
  data.details.uvs = everything || (data.materials.kinds & layout::kHasTexture) != 0;
  data.details.light_words = data.lights.words;
  data.details.default_material = static_cast<std::uint32_t>(materials.values.size()) - 1;
  return data;
}

}  // namespace capcon
