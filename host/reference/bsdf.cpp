#include "reference/bsdf.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/hemisphere.h"
#include "shading/microfacet.h"
#include "shading/spectrum.h"

namespace capcon::reference {
namespace {

using glm::dvec3;
using std::numbers::pi;

double fifth(double x) {
  return x * x * x * x * x;
}

dvec3 schlick(double cosine, const dvec3& at_normal) {
  return at_normal + (1.0 - at_normal) * fifth(1 - cosine);
}

dvec3 fresnel_rgb(double cosine, const Material& m) {
  return {fresnel(cosine, m.eta.x, m.k.x), fresnel(cosine, m.eta.y, m.k.y), fresnel(cosine, m.eta.z, m.k.z)};
}

/// What the coat or the metal reflects at this cosine.
dvec3 reflected(double cosine, const Material& m) {
  if (m.kind == MaterialKind::plastic && m.coat == Coat::substrate) return schlick(cosine, m.specular);
  return m.specular * fresnel_rgb(cosine, m);
}

}  // namespace

dvec3 sample_visible_normal(const dvec3& out, double alpha, const glm::dvec2& point) {
  const dvec3 v = glm::normalize(dvec3(alpha * out.x, alpha * out.y, out.z));
  const dvec3 t1 = v.z > 0.99999 ? dvec3(1, 0, 0) : glm::normalize(glm::cross(dvec3(0, 0, 1), v));
  const dvec3 t2 = glm::cross(v, t1);
  glm::dvec2 t = concentric_disk(point.x, point.y);
  const double k = (1 + v.z) / 2;
  t.y = (1 - k) * std::sqrt(std::max(0.0, 1 - t.x * t.x)) + k * t.y;
  const dvec3 n = t.x * t1 + t.y * t2 + std::sqrt(std::max(0.0, 1 - glm::dot(t, t))) * v;
  const dvec3 h = glm::normalize(dvec3(alpha * n.x, alpha * n.y, std::max(1e-6, n.z)));
  return 2 * glm::dot(out, h) * h - out;
}

dvec3 Bsdf::coat(const dvec3& in, const dvec3& out) const {
  const dvec3 half = glm::normalize(in + out);
  const double microfacets = ggx(half.z, material_.alpha) * ggx_masking(in.z, material_.alpha) *
                             ggx_masking(out.z, material_.alpha) / (4 * in.z * out.z);
  return reflected(glm::dot(out, half), material_) * microfacets;
}

dvec3 Bsdf::base(const dvec3& in, const dvec3& out) const {
  switch (material_.coat) {
    case Coat::added:
      break;
    case Coat::substrate:
      return base_ * (28 / (23 * pi)) * (1.0 - material_.specular) * (1 - fifth(1 - in.z / 2)) *
             (1 - fifth(1 - out.z / 2));
    case Coat::transmitted: {
      const double eta = material_.eta.x;
      const double through = (1 - fresnel(in.z, eta, 0)) * (1 - fresnel(out.z, eta, 0));
      return base_ / pi * through / (eta * eta * (1.0 - base_ * inner_));
    }
  }
  return base_ / pi;
}

dvec3 Bsdf::evaluate(const dvec3& in, const dvec3& out) const {
  if (!(in.z > 0 && out.z > 0)) return dvec3(0);
  switch (material_.kind) {
    case MaterialKind::diffuse:
      return base_ / pi;
    case MaterialKind::conductor:
      return coat(in, out);
    case MaterialKind::plastic:
      return base(in, out) + coat(in, out);
    case MaterialKind::measured:
      return (*measured_)(in, out);
  }
  return dvec3(0);
}

double Bsdf::specular_part(double cosine) const {
  if (material_.kind == MaterialKind::diffuse) return 0;
  if (material_.kind == MaterialKind::conductor) return 1;
  if (material_.kind == MaterialKind::measured) return measured_->specular_weight;
  const bool substrate = material_.coat == Coat::substrate;
  const dvec3 f =
      substrate ? schlick(cosine, material_.specular) : dvec3(fresnel(cosine, material_.eta.x, 0));
  const double specular = substrate ? luminance(f) : luminance(material_.specular * f);
  const double diffuse = luminance(base_ * (1.0 - f));
  return specular + diffuse > 0 ? specular / (specular + diffuse) : 0;
}

double Bsdf::pdf(const dvec3& in, const dvec3& out) const {
  if (!(in.z > 0 && out.z > 0)) return 0;
  const double s = specular_part(out.z);
  double density = 0;
  if (s > 0) density += s * visible_normals_pdf(in, out, alpha());
  if (s < 1) density += (1 - s) * in.z / pi;
  return density;
}

std::optional<dvec3> Bsdf::sample(const dvec3& out, const glm::dvec2& point, double choice) const {
  const dvec3 in = choice < specular_part(out.z) ? sample_visible_normal(out, alpha(), point)
                                                 : cosine_hemisphere(point.x, point.y);
  if (!(in.z > 0)) return {};
  return in;
}

Bsdfs::Bsdfs(const Scene& scene) : scene_(scene), materials_(read_materials(scene)) {
  for (const Material& m : materials_.values) {
    const bool needed = m.kind == MaterialKind::plastic && m.coat == Coat::transmitted;
    inner_.push_back(needed ? inner_reflectance(m.eta.x) : 0);
  }
}

Bsdf Bsdfs::at(int material, const glm::dvec2& uv) const {
  const Material& m = materials_.of(material);
  const std::size_t index = &m - materials_.values.data();
  const dvec3 base =
      m.texture < 0 ? m.reflectance : lookup(materials_.textures[m.texture], scene_.images, uv);
  return {m, base, inner_[index],
          m.kind == MaterialKind::measured ? &materials_.measured[m.measured] : nullptr};
}

}  // namespace capcon::reference
