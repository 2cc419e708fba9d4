#include "render/material_data.h"

#include "layout.h"
#include "render/texels.h"

namespace capcon {
namespace {

constexpr std::size_t kTexelsAMaterial = 5;
constexpr std::size_t kTexelsATexture = 4;

std::uint32_t kind_of(const Material& m) {
  switch (m.kind) {
    case MaterialKind::diffuse:
      return layout::kHasDiffuse;
    case MaterialKind::conductor:
      return layout::kHasConductor;
    case MaterialKind::measured:
      return layout::kHasMeasured;
    case MaterialKind::plastic:
      break;
  }
  if (m.coat == Coat::substrate) return layout::kHasSubstrate;
  return m.coat == Coat::transmitted ? layout::kHasTransmitted : layout::kHasAdded;
}

std::uint32_t wrap_of(Wrap wrap) {
  return wrap == Wrap::repeat  ? layout::kWrapRepeat
         : wrap == Wrap::black ? layout::kWrapBlack
                               : layout::kWrapClamp;
}

/// The header of a texture; its pixels are appended. A texture without an image is one pixel of its average.
void pack_texture(const Scene& scene, const Texture& texture, glm::uvec4* header,
                  std::vector<glm::uvec4>& pixels) {
  const auto first = static_cast<std::uint32_t>(pixels.size());
  if (texture.image < 0) {
    pixels.push_back(make_texel(texture.average, 0u));
    header[0] = {first, 1, 1, layout::kWrapClamp};
    header[1] = glm::uvec4(0);
    header[2] = make_texel(glm::dvec3(1), 0u);
  } else {
    const Image& image = scene.images[texture.image].image;
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) pixels.push_back(make_texel(texel(texture, image, x, y), 0u));
    }
    header[0] = {first, image.width, image.height, wrap_of(texture.wrap)};
    header[1] = {float_bits(texture.scale.x), float_bits(texture.scale.y), float_bits(texture.offset.x),
                 float_bits(texture.offset.y)};
    header[2] = make_texel(texture.factor, 0u);
  }
  header[3] = make_texel(texture.average, 0u);
}

}  // namespace

MaterialData pack_materials(const Scene& scene, const Materials& materials) {
  MaterialData data;
  const std::size_t first_texture = kTexelsAMaterial * materials.values.size();
  const std::size_t first_table = first_texture + kTexelsATexture * materials.textures.size();
  constexpr std::size_t kNodes =
      std::size_t(MeasuredBrdf::kHalf) * MeasuredBrdf::kDifference * MeasuredBrdf::kAzimuth;
  data.materials.reserve(first_table + kNodes * materials.measured.size());
  for (const Material& m : materials.values) {
    const bool measured = m.kind == MaterialKind::measured;
    const MeasuredBrdf* table = measured ? &materials.measured[m.measured] : nullptr;
    const bool textured = m.texture >= 0;
    // Lanes without a texture or table read the first, and drop it.
    const auto texture =
        static_cast<std::uint32_t>(first_texture + kTexelsATexture * (textured ? m.texture : 0));
    const auto place = static_cast<std::uint32_t>(first_table + kNodes * (measured ? m.measured : 0));
    const std::uint32_t kind = kind_of(m) | (textured ? layout::kHasTexture : 0);
    const double chance = measured ? table->specular_weight : m.kind == MaterialKind::conductor ? 1 : 0;
    const double inner = m.coat == Coat::transmitted ? inner_reflectance(m.eta.x) : 0;
    data.kinds |= kind;
    data.materials.push_back({kind, float_bits(measured ? table->alpha : m.alpha), texture, place});
    data.materials.push_back(make_texel(m.reflectance, 0u));
    data.materials.push_back(make_texel(m.specular, chance));
    data.materials.push_back(make_texel(m.eta, inner));
    data.materials.push_back(make_texel(m.k, 0u));
  }
  data.materials.resize(first_table);
  for (std::size_t t = 0; t < materials.textures.size(); ++t) {
    pack_texture(scene, materials.textures[t], &data.materials[first_texture + kTexelsATexture * t],
                 data.textures);
  }
  for (const MeasuredBrdf& table : materials.measured) {
    for (const glm::vec3& value : table.values) data.materials.push_back(make_texel(glm::dvec3(value), 0u));
  }
  return data;
}

}  // namespace capcon
