#include "render/light_data.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "layout.h"
#include "render/geometry_tree.h"
#include "render/texels.h"
#include "shading/virtual_light.h"

namespace capcon {
namespace {

constexpr std::size_t kTexelsALight = 8;

std::uint32_t kind_of(const Light& light) {
  switch (light.kind) {
    case LightKind::disk:
      return layout::kLightDisk;
    case LightKind::sphere:
      return layout::kLightSphere;
    case LightKind::rectangle:
      return layout::kLightRectangle;
    case LightKind::triangles:
      return layout::kLightTriangles;
    case LightKind::environment:
      return light.environment >= 0 ? layout::kLightMap : layout::kLightConstant;
    case LightKind::distant:
      return layout::kLightDistant;
    case LightKind::point:
      break;
  }
  return layout::kLightPoint;
}

/// The ids of a shape's primitives, as Geometry counts them.
struct Ids {
  std::uint32_t first = layout::kNoPrimitive, more = 0;
};

std::vector<Ids> ids_of_lights(const Scene& scene, const Lights& lights) {
  std::vector<Ids> ids(lights.values.size());
  std::uint32_t primitive = 0, quadric = 0;
  for (std::size_t s = 0; s < scene.shapes.size(); ++s) {
    const bool mesh = scene.shapes[s].kind == ShapeKind::mesh;
    const auto count = static_cast<std::uint32_t>(primitive_count(scene, scene.shapes[s]));
    if (lights.of_shape[s] >= 0) {
      ids[lights.of_shape[s]] = mesh ? Ids{primitive, count - 1} : Ids{layout::kQuadricBit | quadric, 0};
    }
    primitive += count;
    if (!mesh) ++quadric;
  }
  return ids;
}

/// The light of each primitive of a shape, and whether it shines to the side from which the vertices in the
/// mesh's order are clockwise.
std::vector<std::uint32_t> words_of_shape(const Scene& scene, const Lights& lights, const Shape& shape,
                                          int index) {
  const Light& light = lights.values[index];
  const auto word = static_cast<std::uint32_t>(index);
  if (shape.kind != ShapeKind::mesh) return {word | (shape.reverse_orientation ? layout::kLightTurned : 0)};
  const TriangleMesh& mesh = scene.meshes[shape.mesh];
  std::vector<std::uint32_t> words(mesh.triangles.size(), word);
  const auto turn = [&](std::uint32_t triangle, const glm::dvec3& normal) {
    glm::dvec3 p[3];
    for (int k = 0; k < 3; ++k) {
      const glm::vec3& v = mesh.positions[mesh.triangles[triangle][k]];
      p[k] = glm::dvec3(shape.to_world * glm::dvec4(v, 1));
    }
    if (glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), normal) < 0) words[triangle] |= layout::kLightTurned;
  };
  if (light.kind == LightKind::rectangle) {
    for (std::uint32_t t = 0; t < words.size(); ++t) turn(t, light.normal);
  }
  for (std::uint32_t k = 0; k < light.triangle_count; ++k) {
    const LightTriangle& t = lights.triangles[light.first_triangle + k];
    turn(t.primitive, glm::cross(t.b - t.a, t.c - t.a));
  }
  return words;
}

/// v with dot(v, a) = 1 and dot(v, b) = 0, in the plane of both.
glm::dvec3 dual(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 across = a - glm::dot(a, b) / glm::dot(b, b) * b;
  return across / glm::dot(across, a);
}

/// Three texels a triangle. A float would hold the sums of 100,000 triangles to a hundredth of a triangle
/// only.
void append_triangles(const Lights& lights, std::vector<glm::uvec4>& texels) {
  for (const Light& l : lights.values) {
    for (std::uint32_t t = l.first_triangle; t < l.first_triangle + l.triangle_count; ++t) {
      const double part = std::min(lights.areas[t] / l.area * 0x1p32, 0x1p32 - 1);
      texels.push_back(make_texel(lights.triangles[t].a, static_cast<std::uint32_t>(part)));
      texels.push_back(make_texel(lights.triangles[t].b, lights.triangles[t].primitive));
      texels.push_back(make_texel(lights.triangles[t].c, 0u));
    }
  }
}

}  // namespace

std::uint32_t LightData::kind_bits() const {
  std::uint32_t bits = 0;
  for (const std::uint32_t kind : kinds) bits |= 1u << kind;
  return bits;
}

LightData pack_lights(const Scene& scene, const Lights& lights) {
  LightData data;
  const std::vector<Ids> ids = ids_of_lights(scene, lights);
  std::vector<std::uint32_t> maps;
  for (const Environment& e : lights.environments) {
    maps.push_back(append_map(scene.images[e.image].image, e.table, data.environments));
    data.octahedral = data.octahedral || e.table.map == SphereMap::octahedral;
  }
  std::vector<glm::dvec3> powers;
  for (const Light& l : lights.values) powers.push_back(l.power);
  const std::vector<std::uint32_t> thresholds = power_thresholds(powers);
  const std::size_t first_triangle = kTexelsALight * lights.values.size();
  for (std::size_t j = 0; j < lights.values.size(); ++j) {
    const Light& l = lights.values[j];
    const std::uint32_t kind = kind_of(l);
    data.kinds.push_back(kind);
    if (kind <= layout::kLightTriangles) data.area_lights = static_cast<std::uint32_t>(j) + 1;
    const std::uint32_t flags = (l.two_sided ? layout::kLightTwoSided : 0) |
                                (l.hidden ? layout::kLightHidden : 0) | (l.inward ? layout::kLightInward : 0);
    const bool environment = l.kind == LightKind::environment;
    std::size_t place = 0;
    if (kind == layout::kLightTriangles) place = first_triangle + 3 * std::size_t(l.first_triangle);
    if (kind == layout::kLightRectangle) place = kTexelsALight * j + 6;
    if (kind == layout::kLightMap) place = maps[l.environment];
    const glm::dmat3 rows = glm::transpose(l.to_light);
    data.lights.push_back({kind, flags, ids[j].first, ids[j].more});
    data.lights.push_back(make_texel(l.radiance, l.area));
    data.lights.push_back(make_texel(environment ? rows[0] : l.position, l.radius));
    data.lights.push_back(make_texel(environment ? rows[1] : l.axis_u, l.inner));
    data.lights.push_back(make_texel(environment ? rows[2] : l.axis_v, static_cast<std::uint32_t>(place)));
    data.lights.push_back(make_texel(l.normal, l.triangle_count));
    const bool flat = kind == layout::kLightRectangle;
    data.lights.push_back(make_texel(flat ? dual(l.axis_u, l.axis_v) : glm::dvec3(0), thresholds[j]));
    data.lights.push_back(make_texel(flat ? dual(l.axis_v, l.axis_u) : glm::dvec3(0), 0u));
  }
  append_triangles(lights, data.lights);
  data.words.resize(scene.shapes.size());
  for (std::size_t s = 0; s < scene.shapes.size(); ++s) {
    if (lights.of_shape[s] >= 0)
      data.words[s] = words_of_shape(scene, lights, scene.shapes[s], lights.of_shape[s]);
  }
  return data;
}

}  // namespace capcon
