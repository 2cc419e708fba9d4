#include "reference/light_sampling.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>

#include "reference/hemisphere.h"
#include "reference/light_geometry.h"

namespace capcon::reference {
namespace {

using glm::dot;
using glm::dvec3;
using std::numbers::pi;

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

/// To the nearer side of a sphere from outside; rays that miss it by rounding graze it.
double near_distance(const Light& sphere, const dvec3& origin, const dvec3& direction) {
  const dvec3 to_centre = sphere.position - origin;
  const double along = dot(to_centre, direction);
  const dvec3 across = to_centre - along * direction;
  return along - std::sqrt(std::max(0.0, sphere.radius * sphere.radius - dot(across, across)));
}

/// The unit square onto the triangle (0, 0), (1, 0), (0, 1): Heitz, "A Low-Distortion Map Between Triangle
/// and Square", 2019.
glm::dvec2 triangle_of_square(glm::dvec2 u) {
  if (u.y > u.x) {
    u.x /= 2;
    u.y -= u.x;
  } else {
    u.y /= 2;
    u.x -= u.y;
  }
  return u;
}

}  // namespace

SampleDomain LightSampling::domain(int light, const dvec3& origin) const {
  const Light& l = lights_.values[light];
  const bool disk = l.kind == LightKind::disk || (l.kind == LightKind::sphere && outside(l, origin)) ||
                    (l.kind == LightKind::environment && l.environment < 0);
  const bool round = l.kind == LightKind::environment || l.kind == LightKind::sphere;
  return disk ? SampleDomain::disk : round ? SampleDomain::cylinder : SampleDomain::square;
}

AreaPoint LightSampling::on_triangles(int light, const glm::dvec2& point) const {
  const Light& l = lights_.values[light];
  const auto first = lights_.areas.begin() + l.first_triangle, last = first + l.triangle_count;
  const double area = point.x * l.area;
  const auto chosen = std::min(std::upper_bound(first, last, area), last - 1);
  const double before = chosen == first ? 0 : *(chosen - 1);
  const auto number = static_cast<std::uint32_t>(chosen - lights_.areas.begin());
  const LightTriangle& t = lights_.triangles[number];
  const glm::dvec2 u = triangle_of_square({(area - before) / (*chosen - before), point.y});
  const std::uint32_t own = triangle_primitives_[number];
  return {t.a + u.x * (t.b - t.a) + u.y * (t.c - t.a), normal_of(t), own, own == Ignored::kNone ? 0u : 1u};
}

AreaPoint LightSampling::point_on(int light, const glm::dvec2& point) const {
  const Light& l = lights_.values[light];
  const Range& own = ranges_[light];
  switch (l.kind) {
    case LightKind::disk: {
      glm::dvec2 d = concentric_disk(point.x, point.y);
      const double r2 = dot(d, d);
      if (l.inner > 0)  // onto the ring; a centre that has no direction goes along u
        d = r2 > 0 ? d * std::sqrt((l.inner * l.inner + (1 - l.inner * l.inner) * r2) / r2)
                   : glm::dvec2(l.inner, 0);
      return {l.position + d.x * l.axis_u + d.y * l.axis_v, l.normal, own.first, own.count};
    }
    case LightKind::rectangle:
      return {l.position + point.x * l.axis_u + point.y * l.axis_v, l.normal, own.first, own.count};
    case LightKind::triangles:
      return on_triangles(light, point);
    default: {
      assert(l.kind == LightKind::sphere);
      const double z = 1 - 2 * point.y, ring = std::sqrt(std::max(0.0, 1 - z * z));
      const dvec3 normal(ring * std::cos(2 * pi * point.x), ring * std::sin(2 * pi * point.x), z);
      return {l.position + l.radius * normal, l.inward ? -normal : normal, own.first, own.count};
    }
  }
}

LightSample LightSampling::from_area(int light, const dvec3& origin, const glm::dvec2& point) const {
  const Light& l = lights_.values[light];
  const AreaPoint on = point_on(light, point);
  const dvec3 to = on.position - origin;
  const double distance = glm::length(to);
  const dvec3 direction = to / distance;
  LightSample sample{
      direction, distance, area_pdf(l.area, to, on.normal), side_radiance(l, on.normal, direction),
      on.first,  on.count};
  // The triangles lie within the ellipsoid: from outside it hides them, and is ignored. From the inner side
  // it is behind them, or its nearer side is rightly in the way.
  if (is_ellipsoid(light) &&
      (dot(on.normal, to) > 0) != primitives_.placement(on.first).shape->reverse_orientation)
    sample.count = 0;
  return sample;
}

LightSample LightSampling::from_sphere(const Light& light, const dvec3& origin,
                                       const glm::dvec2& point) const {
  const double c = cone_height(light, origin);
  const glm::dvec2 d = concentric_disk(point.x, point.y);
  const double d2 = dot(d, d);
  const double spread = std::sqrt(c * (2 - d2 * c));
  const Frame frame(glm::normalize(light.position - origin));
  const dvec3 direction = glm::normalize(frame.to_world({spread * d.x, spread * d.y, 1 - d2 * c}));
  const dvec3 radiance = light.inward && !light.two_sided ? dvec3(0) : light.radiance;
  return {direction, near_distance(light, origin, direction), 1 / (2 * pi * c), radiance};
}

std::optional<LightSample> LightSampling::sample(int light, const dvec3& origin, const dvec3& normal,
                                                 const glm::dvec2& point) const {
  const Light& l = lights_.values[light];
  LightSample sample{};
  switch (l.kind) {
    case LightKind::disk:
    case LightKind::rectangle:
    case LightKind::triangles:
      sample = from_area(light, origin, point);
      break;
    case LightKind::sphere:
      sample = outside(l, origin) ? from_sphere(l, origin, point) : from_area(light, origin, point);
      sample.first = ranges_[light].first;
      sample.count = ranges_[light].count;
      break;
    case LightKind::environment:
      if (l.environment >= 0) {
        const EnvironmentSample s = sample_environment(lights_.environments[l.environment].table, point);
        const dvec3 direction = glm::normalize(glm::transpose(l.to_light) * s.direction);
        sample = {direction, kNoEnd, s.pdf, environment_radiance(scene_, lights_, l, direction)};
      } else {
        const dvec3 local = cosine_hemisphere(point.x, point.y);
        sample = {glm::normalize(around_normal(normal, local)), kNoEnd, local.z / pi, l.radiance};
      }
      break;
    case LightKind::distant:
      sample = {-l.normal, kNoEnd, 1, l.radiance};
      break;
    case LightKind::point: {
      const dvec3 to = l.position - origin;
      sample = {glm::normalize(to), glm::length(to), 1, l.radiance / dot(to, to)};
      break;
    }
  }
  // Also what is seen edge on or from no distance: infinite or no densities.
  const bool gives =
      sample.distance > 0 && sample.pdf > 0 && sample.pdf < 1e300 && sample.radiance != dvec3(0);
  if (!gives) return {};
  return sample;
}

}  // namespace capcon::reference
