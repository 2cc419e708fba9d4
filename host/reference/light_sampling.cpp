#include "reference/light_sampling.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>

#include "reference/hemisphere.h"

namespace capcon::reference {
namespace {

using glm::dot;
using glm::dvec3;
using std::numbers::pi;

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

bool outside(const Light& sphere, const dvec3& origin) {
  return glm::distance(origin, sphere.position) > sphere.radius;
}

/// 1 - cos(theta_max) of the cone under which a sphere is seen from outside.
double cone_height(const Light& sphere, const dvec3& origin) {
  const double distance = glm::distance(origin, sphere.position);
  const double cosine2 = (distance - sphere.radius) * (distance + sphere.radius) / (distance * distance);
  return (1 - cosine2) / (1 + std::sqrt(std::max(0.0, cosine2)));
}

/// To the nearer side of a sphere from outside; rays that miss it by rounding graze it.
double near_distance(const Light& sphere, const dvec3& origin, const dvec3& direction) {
  const dvec3 to_centre = sphere.position - origin;
  const double along = dot(to_centre, direction);
  const dvec3 across = to_centre - along * direction;
  return along - std::sqrt(std::max(0.0, sphere.radius * sphere.radius - dot(across, across)));
}

dvec3 normal_of(const LightTriangle& t) {
  return glm::normalize(glm::cross(t.b - t.a, t.c - t.a));
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

/// Samples that lie `area` wide and one by one towards `to` = direction * distance.
double area_pdf(double area, const dvec3& to, const dvec3& normal) {
  const double distance2 = dot(to, to);
  return distance2 * std::sqrt(distance2) / (area * std::abs(dot(to, normal)));
}

/// What a side gives to rays that go in `direction`.
dvec3 side_radiance(const Light& light, const dvec3& normal, const dvec3& direction) {
  return light.two_sided || dot(normal, direction) < 0 ? light.radiance : dvec3(0);
}

}  // namespace

LightSampling::LightSampling(const Scene& scene, const Primitives& primitives)
    : scene_(scene), primitives_(primitives), lights_(read_lights(scene)) {
  find_primitives();
}

int LightSampling::of(const Placement& placement) const {
  return placement.instance ? -1 : lights_.of_shape[placement.shape - scene_.shapes.data()];
}

int LightSampling::of_primitive(std::uint32_t primitive) const {
  return of(primitives_.placement(primitive));
}

void LightSampling::find_primitives() {
  ranges_.resize(lights_.values.size());
  triangle_primitives_.assign(lights_.triangles.size(), Ignored::kNone);
  for (const Placement& placement : primitives_.rounds()) {
    const int light = of(placement);
    if (light < 0) continue;
    ranges_[light] = {placement.first, 1};
    // An ellipsoid, of many triangles.
    const Light& l = lights_.values[light];
    std::fill_n(triangle_primitives_.begin() + l.first_triangle, l.triangle_count, placement.first);
  }
  for (const Placement& placement : primitives_.meshes()) {
    const int light = of(placement);
    if (light < 0) continue;
    const TriangleMesh& mesh = scene_.meshes[placement.shape->mesh];
    ranges_[light] = {placement.first, static_cast<std::uint32_t>(mesh.triangles.size())};
    // Triangles without area are no part of the light; the others follow in order.
    const Light& l = lights_.values[light];
    std::uint32_t next = l.first_triangle;
    for (std::uint32_t t = 0; t < mesh.triangles.size() && l.kind == LightKind::triangles; ++t) {
      dvec3 p[3];
      for (int k = 0; k < 3; ++k)
        p[k] = dvec3(placement.shape->to_world * glm::dvec4(mesh.positions[mesh.triangles[t][k]], 1));
      if (glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) / 2 > 0)
        triangle_primitives_.at(next++) = placement.first + t;
    }
    assert(l.kind != LightKind::triangles || next == l.first_triangle + l.triangle_count);
  }
}

bool LightSampling::is_ellipsoid(int light) const {
  const Range& range = ranges_[light];
  return lights_.values[light].kind == LightKind::triangles && range.count > 0 &&
         primitives_.placement(range.first).shape->kind == ShapeKind::sphere;
}

bool LightSampling::findable(int light) const {
  const Light& l = lights_.values[light];
  return !l.hidden && l.kind != LightKind::point && l.kind != LightKind::distant;
}

SampleDomain LightSampling::domain(int light, const dvec3& origin) const {
  const Light& l = lights_.values[light];
  const bool disk = l.kind == LightKind::disk || (l.kind == LightKind::sphere && outside(l, origin)) ||
                    (l.kind == LightKind::environment && l.environment < 0);
  return disk ? SampleDomain::disk : SampleDomain::square;
}

LightSample LightSampling::from_area(const Light& light, const dvec3& normal, const dvec3& to,
                                     const Range& own) const {
  const double distance = glm::length(to);
  const dvec3 direction = to / distance;
  return {direction, distance, area_pdf(light.area, to, normal), side_radiance(light, normal, direction),
          own.first, own.count};
}

LightSample LightSampling::from_sphere(const Light& light, const dvec3& origin,
                                       const glm::dvec2& point) const {
  if (outside(light, origin)) {
    const double c = cone_height(light, origin);
    const glm::dvec2 d = concentric_disk(point.x, point.y);
    const double d2 = dot(d, d);
    const double spread = std::sqrt(c * (2 - d2 * c));
    const Frame frame(glm::normalize(light.position - origin));
    const dvec3 direction = glm::normalize(frame.to_world({spread * d.x, spread * d.y, 1 - d2 * c}));
    const dvec3 radiance = light.inward && !light.two_sided ? dvec3(0) : light.radiance;
    return {direction, near_distance(light, origin, direction), 1 / (2 * pi * c), radiance};
  }
  const double z = 1 - 2 * point.y, ring = std::sqrt(std::max(0.0, 1 - z * z));
  const dvec3 normal(ring * std::cos(2 * pi * point.x), ring * std::sin(2 * pi * point.x), z);
  const dvec3 to = light.position + light.radius * normal - origin;
  LightSample sample = from_area(light, normal, to, {});
  sample.radiance = light.inward || light.two_sided ? light.radiance : dvec3(0);
  return sample;
}

LightSample LightSampling::from_triangles(int light, const dvec3& origin, const glm::dvec2& point) const {
  const Light& l = lights_.values[light];
  const auto first = lights_.areas.begin() + l.first_triangle, last = first + l.triangle_count;
  const double area = point.x * l.area;
  const auto chosen = std::min(std::upper_bound(first, last, area), last - 1);
  const double before = chosen == first ? 0 : *(chosen - 1);
  const auto number = static_cast<std::uint32_t>(chosen - lights_.areas.begin());
  const LightTriangle& t = lights_.triangles[number];
  const glm::dvec2 u = triangle_of_square({(area - before) / (*chosen - before), point.y});
  const dvec3 to = t.a + u.x * (t.b - t.a) + u.y * (t.c - t.a) - origin;
  const dvec3 normal = normal_of(t);
  const std::uint32_t own = triangle_primitives_[number];
  Range ignored = own == Ignored::kNone ? Range{} : Range{own, 1};
  // The triangles lie within the ellipsoid: from outside it hides them, and is ignored. From the inner side
  // it is behind them, or its nearer side is rightly in the way.
  if (is_ellipsoid(light) && (dot(normal, to) > 0) != primitives_.placement(own).shape->reverse_orientation)
    ignored = {};
  return from_area(l, normal, to, ignored);
}

std::optional<LightSample> LightSampling::sample(int light, const dvec3& origin, const dvec3& normal,
                                                 const glm::dvec2& point) const {
  const Light& l = lights_.values[light];
  LightSample sample{};
  switch (l.kind) {
    case LightKind::disk: {
      glm::dvec2 d = concentric_disk(point.x, point.y);
      const double r2 = dot(d, d);
      if (l.inner > 0)  // onto the ring; a centre that has no direction goes along u
        d = r2 > 0 ? d * std::sqrt((l.inner * l.inner + (1 - l.inner * l.inner) * r2) / r2)
                   : glm::dvec2(l.inner, 0);
      sample = from_area(l, l.normal, l.position + d.x * l.axis_u + d.y * l.axis_v - origin, ranges_[light]);
      break;
    }
    case LightKind::rectangle:
      sample = from_area(l, l.normal, l.position + point.x * l.axis_u + point.y * l.axis_v - origin,
                         ranges_[light]);
      break;
    case LightKind::sphere:
      sample = from_sphere(l, origin, point);
      sample.first = ranges_[light].first;
      sample.count = ranges_[light].count;
      break;
    case LightKind::triangles:
      sample = from_triangles(light, origin, point);
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

LightMet LightSampling::meet(int light, std::uint32_t primitive, const Ray& ray, double t) const {
  const Light& l = lights_.values[light];
  const dvec3 to = t * ray.direction;
  dvec3 normal = l.normal;
  if (l.kind == LightKind::sphere) {
    const bool out = outside(l, ray.origin);
    const bool gives = l.two_sided || l.inward != out;
    if (out) return {gives ? l.radiance : dvec3(0), 1 / (2 * pi * cone_height(l, ray.origin))};
    normal = glm::normalize(ray.origin + to - l.position);
    return {gives ? l.radiance : dvec3(0), area_pdf(l.area, to, normal)};
  }
  if (is_ellipsoid(light)) {
    normal = primitives_.surface(primitive, ray, t).normal;
    if (primitives_.placement(primitive).shape->reverse_orientation) normal = -normal;
  } else if (l.kind == LightKind::triangles) {
    const auto first = triangle_primitives_.begin() + l.first_triangle, last = first + l.triangle_count;
    const auto found = std::lower_bound(first, last, primitive);
    if (found == last || *found != primitive) return {};
    normal = normal_of(lights_.triangles[found - triangle_primitives_.begin()]);
  }
  return {side_radiance(l, normal, ray.direction), area_pdf(l.area, to, normal)};
}

LightMet LightSampling::environment(int light, const dvec3& normal, const dvec3& direction) const {
  const Light& l = lights_.values[light];
  if (l.environment < 0) return {l.radiance, std::max(0.0, dot(normal, direction)) / pi};
  const EnvironmentTable& table = lights_.environments[l.environment].table;
  return {environment_radiance(scene_, lights_, l, direction),
          environment_pdf(table, l.to_light * direction)};
}

dvec3 LightSampling::background(const dvec3& direction) const {
  dvec3 sum(0);
  for (const Light& light : lights_.values) {
    if (light.kind == LightKind::environment) sum += environment_radiance(scene_, lights_, light, direction);
  }
  return sum;
}

}  // namespace capcon::reference
