// Fuzzes what materials, textures and lights are read from: whatever pbrt text, the answer is values within
// their bounds or an InputError. See README.md beside.
#include "base/error.h"
#include "fuzz_check.h"
#include "scene/pbrt_reader.h"
#include "shading/light.h"
#include "shading/material.h"

namespace {

void check(const capcon::Materials& materials) {
  using capcon::fuzz::require;
  for (const capcon::Material& material : materials.values) {
    for (int c = 0; c < 3; ++c) {
      require(material.reflectance[c] >= 0 && material.reflectance[c] <= 1);
      require(material.specular[c] >= 0 && material.specular[c] <= 1);
      require(material.eta[c] >= 0 && material.k[c] >= 0);
    }
    require(material.alpha > 0 && material.alpha <= 1);
    require(material.texture < static_cast<int>(materials.textures.size()));
    require(material.measured < static_cast<int>(materials.measured.size()));
  }
}

void check(const capcon::Lights& lights) {
  using capcon::fuzz::require;
  require(lights.areas.size() == lights.triangles.size());
  for (const capcon::Light& light : lights.values) {
    for (int c = 0; c < 3; ++c) require(light.radiance[c] >= 0 && light.power[c] >= 0);
    require(light.first_triangle + light.triangle_count <= lights.triangles.size());
    require(light.area >= 0);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    const capcon::Scene scene = capcon::parse_pbrt(bytes, "f.pbrt", {true, true});
    check(capcon::read_materials(scene));
    check(capcon::read_lights(scene));
  } catch (const capcon::InputError&) {
  }
  return 0;
}
