#include "reference/vertex.h"

#include <glm/geometric.hpp>

namespace capcon::reference {

using glm::dot;
using glm::dvec3;

dvec3 Vertex::reflect(const dvec3& direction, const dvec3& in) const {
  if (!(dot(direction, at.normal) > 0 && in.z > 0)) return dvec3(0);
  return bsdf.evaluate(in, out) * in.z;
}

std::optional<Continuation> continue_from(const Vertex& vertex, const glm::dvec2& point, double choice) {
  const std::optional<dvec3> in = vertex.bsdf.sample(vertex.out, point, choice);
  if (!in) return {};
  const dvec3 direction = glm::normalize(vertex.frame.to_world(*in));
  const double pdf = vertex.bsdf.pdf(*in, vertex.out);
  const dvec3 reflected = vertex.reflect(direction, *in);
  if (reflected == dvec3(0) || !(pdf > 0)) return {};
  return Continuation{direction, in->z, pdf, reflected};
}

dvec3 turned_normal(const ShadingPoint& surface, const dvec3& geometric) {
  if (surface.normal == dvec3(0)) return geometric;
  return dot(surface.normal, geometric) < 0 ? -surface.normal : surface.normal;
}

dvec3 normal_seen_from(const dvec3& out, const dvec3& turned, const dvec3& geometric) {
  return dot(turned, out) > 0 ? turned : geometric;
}

Vertex Vertices::at(const Seen& seen, const dvec3& out) const {
  const ShadingPoint surface = surfaces_.at(seen.primitive, seen.at);
  const dvec3 turned = turned_normal(surface, seen.at.normal);
  const Frame frame(normal_seen_from(out, turned, seen.at.normal));
  return {seen.at, seen.ignored, bsdfs_.at(surface.material, surface.uv), frame, frame.to_local(out)};
}

}  // namespace capcon::reference
