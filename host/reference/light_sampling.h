#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "reference/tree.h"
#include "sampling/sampler.h"
#include "shading/light.h"

namespace capcon::reference {

/// A direction towards a light.
struct LightSample {
  glm::dvec3 direction;
  double distance;      ///< infinite for environments and distant lights
  double pdf;           ///< in solid angle; 1 for point and distant lights
  glm::dvec3 radiance;  ///< that comes if nothing is between; of point and distant lights irradiance across
                        ///< the direction
  std::uint32_t first = 0, count = 0;  ///< the light's own primitives, which do not hide it
};

/// What a direction that nothing hides brings from a light, and how densely the light's samples lie there.
struct LightMet {
  glm::dvec3 radiance{0};
  double pdf = 0;
};

/// A point on an area light, spread evenly over its area.
struct AreaPoint {
  glm::dvec3 position;
  glm::dvec3 normal;  ///< unit, on the emitting side
  /// What must not hide the point from the emitting side: the chosen triangle of a mesh, else all of the
  /// light.
  std::uint32_t first = 0, count = 0;
};

/// The lights of a scene and the points on them: docs/direct.md's table.
class LightSampling {
 public:
  /// Keeps references. InputError as read_lights.
  LightSampling(const Scene& scene, const Primitives& primitives);

  const Lights& lights() const { return lights_; }
  int count() const { return static_cast<int>(lights_.values.size()); }
  /// The light that a primitive is a part of, -1 for none.
  int of_primitive(std::uint32_t primitive) const;
  /// Whether rays may meet the light: no point, distant or hidden one.
  bool findable(int light) const;
  /// Whether it emits as many triangles inside of the ellipsoid that rays meet.
  bool is_ellipsoid(int light) const;
  /// The domain of the light's points, seen from `origin`.
  SampleDomain domain(int light, const glm::dvec3& origin) const;
  /// Towards the light's point for `point` in [0, 1)^2, from `origin` on a surface with the geometric normal
  /// `normal`. None when it gives nothing there.
  std::optional<LightSample> sample(int light, const glm::dvec3& origin, const glm::dvec3& normal,
                                    const glm::dvec2& point) const;
  /// The point of a disk, rectangle, triangles or sphere (as from inside) for `point` in [0, 1)^2.
  AreaPoint point_on(int light, const glm::dvec2& point) const;
  /// Of a ray that meets `primitive`, which is the light's, at distance t.
  LightMet meet(int light, std::uint32_t primitive, const Ray& ray, double t) const;
  /// Of an environment light, towards `direction` from a surface with the geometric normal `normal`.
  LightMet environment(int light, const glm::dvec3& normal, const glm::dvec3& direction) const;
  /// What it radiates towards us from all environments.
  glm::dvec3 background(const glm::dvec3& direction) const;

 private:
  /// Where the shape of an area light stands in the numbering; count 0 for hidden ones.
  struct Range {
    std::uint32_t first = 0, count = 0;
  };
  void find_primitives();
  int of(const Placement& placement) const;
  LightSample from_area(int light, const glm::dvec3& origin, const glm::dvec2& point) const;
  LightSample from_sphere(const Light& light, const glm::dvec3& origin, const glm::dvec2& point) const;
  AreaPoint on_triangles(int light, const glm::dvec2& point) const;

  const Scene& scene_;
  const Primitives& primitives_;
  Lights lights_;
  std::vector<Range> ranges_;                       ///< one a light
  std::vector<std::uint32_t> triangle_primitives_;  ///< one for each of Lights::triangles
};

}  // namespace capcon::reference
