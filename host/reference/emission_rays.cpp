#include "reference/emission_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "base/error.h"
#include "reference/hemisphere.h"
#include "reference/unit_point.h"
#include "shading/virtual_light.h"

namespace capcon::reference {
namespace {

using glm::dvec3;
using std::numbers::pi;

/// Rays from afar start a little outside of everything.
constexpr double kAround = 1.001;

dvec3 on_sphere(const glm::dvec2& point) {
  const double z = 1 - 2 * point.y, ring = std::sqrt(std::max(0.0, 1 - z * z));
  return {ring * std::cos(2 * pi * point.x), ring * std::sin(2 * pi * point.x), z};
}

bool is_area(LightKind kind) {
  return kind == LightKind::disk || kind == LightKind::sphere || kind == LightKind::rectangle ||
         kind == LightKind::triangles;
}

}  // namespace

EmissionRays::EmissionRays(const Scene& scene, const Geometry& geometry, const LightSampling& lights)
    : scene_(scene), geometry_(geometry), lights_(lights), bounds_(scene_bounds(scene)) {
  bounds_.radius *= kAround;
  std::vector<dvec3> powers;
  for (const Light& light : lights.lights().values) powers.push_back(light.power);
  if (powers.empty())
    throw InputError(scene.name +
                     ": the scene has no light that emits; add one, such as LightSource or AreaLightSource");
  thresholds_ = power_thresholds(powers);
}

SampleDomain EmissionRays::origin_domain() const {
  if (lights_.count() > 1) return SampleDomain::square;
  switch (lights_.lights().values[0].kind) {
    case LightKind::sphere:
      return SampleDomain::cylinder;
    case LightKind::rectangle:
    case LightKind::triangles:
      return SampleDomain::square;
    default:
      return SampleDomain::disk;
  }
}

SampleDomain EmissionRays::direction_domain() const {
  if (lights_.count() > 1) return SampleDomain::square;
  return is_area(lights_.lights().values[0].kind) ? SampleDomain::disk : SampleDomain::cylinder;
}

EmissionRay EmissionRays::from_area(int light, const glm::dvec2& u, const glm::dvec2& v, double side) const {
  const Light& l = lights_.lights().values[light];
  const AreaPoint on = lights_.point_on(light, u);
  const bool turned = l.two_sided && side >= 0.5;
  const dvec3 normal = turned ? -on.normal : on.normal;
  Ignored ignored{Ignored::kNone, on.first, on.count};
  // What emits into a sphere or ellipsoid reaches its other side.
  const bool round = l.kind == LightKind::sphere || lights_.is_ellipsoid(light);
  if (round && l.inward != turned) ignored = {};
  const dvec3 direction = glm::normalize(around_normal(normal, cosine_hemisphere(v.x, v.y)));
  return {on.position + geometry_.offset * normal, direction,
          pi * l.area * l.radiance * (l.two_sided ? 2.0 : 1.0), ignored};
}

EmissionRay EmissionRays::from_afar(const Light& light, const glm::dvec2& u, const glm::dvec2& v) const {
  dvec3 towards = -light.normal;  // the light
  dvec3 radiance = light.radiance;
  if (light.kind == LightKind::environment && light.environment < 0) {
    towards = on_sphere(v);
    radiance *= 4 * pi;
  } else if (light.kind == LightKind::environment) {
    const EnvironmentSample s = sample_environment(lights_.lights().environments[light.environment].table, v);
    towards = glm::normalize(glm::transpose(light.to_light) * s.direction);
    radiance = environment_radiance(scene_, lights_.lights(), light, towards) / s.pdf;
  }
  const glm::dvec2 d = concentric_disk(u.x, u.y);
  const dvec3 from_centre = towards + around_normal(towards, {d.x, d.y, 0});
  return {bounds_.centre + bounds_.radius * from_centre,
          -towards,
          pi * bounds_.radius * bounds_.radius * radiance,
          {}};
}

std::optional<EmissionRay> EmissionRays::start(FixedPoint origin, const glm::dvec2& v, double side) const {
  glm::dvec2 u = unit_point(origin);
  int light = 0;
  double probability = 1;
  if (lights_.count() > 1) {
    const auto found =
        std::min(std::upper_bound(thresholds_.begin(), thresholds_.end(), origin.x), thresholds_.end() - 1);
    light = static_cast<int>(found - thresholds_.begin());
    const double from = light == 0 ? 0 : thresholds_[light - 1];
    const double to = light + 1 == lights_.count() ? 0x1p32 : thresholds_[light];
    u.x = (origin.x - from) / (to - from);
    probability = (to - from) * 0x1p-32;
  }
  const Light& l = lights_.lights().values[light];
  EmissionRay ray = is_area(l.kind) ? from_area(light, u, v, side)
                    : l.kind == LightKind::point
                        ? EmissionRay{l.position, on_sphere(v), 4 * pi * l.radiance, {}}
                        : from_afar(l, u, v);
  ray.flux /= probability;
  if (ray.flux == dvec3(0)) return {};
  return ray;
}

}  // namespace capcon::reference
