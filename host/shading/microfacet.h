#pragma once

#include <glm/vec3.hpp>

namespace capcon {

/// The GGX distribution of normals (Walter, Marschner, Li and Torrance, "Microfacet Models for Refraction
/// through Rough Surfaces", EGSR 2007), at the cosine of a half vector with the normal.
double ggx(double cosine, double alpha);

/// Smith's masking of GGX for a direction of this cosine (ibid., equation 34).
double ggx_masking(double cosine, double alpha);

/// Density in solid angle of the direction `in` when a visible normal of GGX seen from `out` mirrors it
/// (Heitz, "Sampling the GGX Distribution of Visible Normals", JCGT 7(4), 2018): D G1 / (4 cos). Unit
/// directions, z the normal.
double visible_normals_pdf(const glm::dvec3& in, const glm::dvec3& out, double alpha);

}  // namespace capcon
