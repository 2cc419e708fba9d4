#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "shading/material.h"

namespace capcon::reference {

/// A material at a point, docs/direct.md, "BSDFs". Unit directions in the local frame, z the shading normal;
/// `out` is the viewer's, `in` the light's. Keeps references to its arguments.
class Bsdf {
 public:
  /// `base`: the colour that a texture gives in place of Material::reflectance. `inner`:
  /// inner_reflectance(eta), for transmitted coats. `measured`: the table, of measured materials.
  Bsdf(const Material& material, const glm::dvec3& base, double inner, const MeasuredBrdf* measured)
      : material_(material), base_(base), inner_(inner), measured_(measured) {}

  /// f without the cosine; 0 where a direction is not above.
  glm::dvec3 evaluate(const glm::dvec3& in, const glm::dvec3& out) const;
  /// Density of sample() in solid angle.
  double pdf(const glm::dvec3& in, const glm::dvec3& out) const;
  /// The direction `in` of a point of the square and the choice of a component, in [0, 1). None when it is
  /// not above.
  std::optional<glm::dvec3> sample(const glm::dvec3& out, const glm::dvec2& point, double choice) const;

 private:
  glm::dvec3 coat(const glm::dvec3& in, const glm::dvec3& out) const;
  glm::dvec3 base(const glm::dvec3& in, const glm::dvec3& out) const;
  /// Probability of visible normals, which else is the cosine's.
  double specular_part(double cosine) const;
  double alpha() const { return measured_ ? measured_->alpha : material_.alpha; }

  const Material& material_;
  glm::dvec3 base_;
  double inner_;
  const MeasuredBrdf* measured_;
};

/// All materials of a scene.
class Bsdfs {
 public:
  /// Keeps a reference. InputError as read_materials.
  explicit Bsdfs(const Scene& scene);
  /// `material`: as Shape::material.
  Bsdf at(int material, const glm::dvec2& uv) const;
  const std::vector<std::string>& warnings() const { return materials_.warnings; }

 private:
  const Scene& scene_;
  Materials materials_;
  std::vector<double> inner_;  ///< inner_reflectance of each of materials_.values
};

/// The direction into which a visible normal of GGX seen from `out` mirrors it (Heitz, JGCT 7(4), 2018).
glm::dvec3 sample_visible_normal(const glm::dvec3& out, double alpha, const glm::dvec2& point);

}  // namespace capcon::reference
