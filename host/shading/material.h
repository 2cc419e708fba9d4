#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "shading/measured_brdf.h"
#include "shading/texture.h"

namespace capcon {

enum class MaterialKind : std::uint8_t { diffuse, conductor, plastic, measured };

/// How a plastic's diffuse base lies under its coat, and what reflects there. F is fresnel(cosine, eta, 0).
enum class Coat : std::uint8_t {
  /// base/pi + coat, the coat reflects specular F: pbrt-v2's and v3's "plastic", "uber".
  added,
  /// The coat reflects F0 + (1 - F0) (1 - cosine)^5, F0 = specular (Schlick), and the base is base 28/(23 pi)
  /// (1 - F0)
  /// (1 - (1 - cos_i/2)^5) (1 - (1 - cos_o/2)^5): Ashikhmin and Shirley, "An Anisotropic Phong BRDF Model",
  /// JGT 5(2),
  /// 2000. eta is not used.
  substrate,
  /// The coat reflects specular F, and the base is base/pi (1 - F(cos_i)) (1 - F(cos_o)) / (eta^2 (1 - base
  /// F_inner)),
  /// F_inner = inner_reflectance(eta): light enters, is reflected between base and coat, and leaves
  /// ("coateddiffuse").
  transmitted
};

/// A material as plain values; colours are linear sRGB. The BRDFs, f without the cosine:
///   diffuse    reflectance/pi
///   conductor  specular F(eta, k) D G1 G1 / (4 cos_i cos_o), D GGX of alpha, G1 Smith's (see microfacet.h)
///   plastic    the same with k = 0, over a diffuse base; Coat says how
///   measured   Materials::measured[measured]
struct Material {
  MaterialKind kind = MaterialKind::diffuse;
  Coat coat = Coat::added;
  glm::dvec3 reflectance{0.5};  ///< diffuse, plastic: the base in [0, 1]; with a texture its average
  glm::dvec3 specular{1};       ///< conductor, plastic: what F is multiplied by, in [0, 1]; see Coat
  glm::dvec3 eta{1};            ///< conductor, plastic
  glm::dvec3 k{0};              ///< conductor
  double alpha = 1;             ///< conductor, plastic: GGX, kSmallestAlpha to 1
  int texture = -1;   ///< diffuse, plastic: index into Materials::textures, which replaces `reflectance`
  int measured = -1;  ///< measured: index into Materials::measured

  bool operator==(const Material&) const = default;
};

struct Materials {
  std::vector<Material>
      values;  ///< one for each of Scene::materials, then the default, of shapes that have none
  std::vector<Texture> textures;
  std::vector<MeasuredBrdf> measured;  ///< each file once
  std::vector<std::string> warnings;   ///< "file:line:column: sentence", at most one a material

  /// Of a shape's index, which is -1 for none.
  const Material& of(int material) const { return material < 0 ? values.back() : values[material]; }
};

/// The materials of a scene that was read with ReadOptions::images. What pbrt has and this program has not
/// (glass, layers, bumps, ...) becomes the nearest of the four kinds and is said once a material. InputError
/// with its place for values that make no sense and for broken files.
Materials read_materials(const Scene& scene);

/// Fresnel reflectance of a conductor, or with k = 0 of a dielectric of relative index eta, for unpolarised
/// light from outside at this cosine.
double fresnel(double cosine, double eta, double k);

/// Mean reflectance of diffuse light from inside a dielectric of index eta >= 1: 1 - (1 - F_outer)/eta^2,
/// F_outer the cosine-weighted mean of fresnel(cosine, eta, 0).
double inner_reflectance(double eta);

}  // namespace capcon
