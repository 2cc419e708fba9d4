#include "study/scene_facts.h"

#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>
#include <limits>
#include <span>
#include <string_view>

#include "base/hash.h"
#include "sampling/sampler.h"

namespace capcon {
namespace {

class Hash {
 public:
  template <class T>
  void add(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::string_view bytes(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    value_ = mix64(value_, fnv1a64(bytes), values.size());
  }
  template <class T>
  void add(const T& value) {
    add(std::span<const T>(&value, 1));
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0;
};

void add_shape(Hash& hash, const Shape& s) {
  hash.add(static_cast<std::uint32_t>(s.kind));
  hash.add(s.mesh);
  for (const double v : {s.radius, s.height, s.inner_radius}) hash.add(v);
  hash.add(s.to_world);
  hash.add(s.material);
  hash.add(s.area_light);
  hash.add(s.reverse_orientation);
}

void add_entity(Hash& hash, const Entity& entity) {
  const auto text = [&](const std::string& s) { hash.add(std::span<const char>(s)); };
  text(entity.type);
  text(entity.name);
  hash.add(entity.to_world);
  hash.add(entity.image);
  for (const auto& [name, entry] : entity.parameters.entries) {
    text(name);
    text(entry.type);
    if (const auto* numbers = std::get_if<std::vector<double>>(&entry.value)) {
      hash.add(std::span<const double>(*numbers));
    } else if (const auto* words = std::get_if<std::vector<std::string>>(&entry.value)) {
      for (const std::string& word : *words) text(word);
    } else {
      for (const bool flag : std::get<std::vector<bool>>(entry.value)) hash.add(flag);
    }
  }
}

struct Box {
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};
  void add(const glm::dvec3& p) {
    low = glm::dvec3(std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z));
    high = glm::dvec3(std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z));
  }
  void add(const glm::dmat4& to_world, const glm::dvec3& p) { add(glm::dvec3(to_world * glm::dvec4(p, 1))); }
  /// The eight corners under a transform.
  void add(const glm::dmat4& to_world, const Box& box) {
    if (box.low.x > box.high.x) return;
    for (int corner = 0; corner < 8; ++corner) {
      add(to_world, {corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                     corner & 4 ? box.high.z : box.low.z});
    }
  }
};

Box box_of(const Scene& scene, const std::vector<Shape>& shapes) {
  Box box;
  for (const Shape& s : shapes) {
    if (s.area_light >= 0) continue;
    if (s.kind == ShapeKind::mesh) {
      for (const glm::vec3& p : scene.meshes[s.mesh].positions) box.add(s.to_world, glm::dvec3(p));
      continue;
    }
    Box around;
    const double depth = s.kind == ShapeKind::sphere ? s.radius : 0;
    around.add(glm::dvec3{-s.radius, -s.radius, s.height - depth});
    around.add(glm::dvec3{s.radius, s.radius, s.height + depth});
    box.add(s.to_world, around);
  }
  return box;
}

}  // namespace

std::uint64_t fingerprint(const Scene& scene) {
  Hash hash;
  for (const TriangleMesh& mesh : scene.meshes) {
    hash.add(std::span<const glm::vec3>(mesh.positions));
    hash.add(std::span<const glm::uvec3>(mesh.triangles));
  }
  for (const TriangleMesh& mesh : scene.meshes) {
    hash.add(std::span<const glm::vec3>(mesh.normals));
    hash.add(std::span<const glm::vec2>(mesh.uvs));
  }
  for (const auto* entities : {&scene.materials, &scene.lights, &scene.area_lights, &scene.textures}) {
    for (const Entity& entity : *entities) add_entity(hash, entity);
  }
  for (const SceneImage& image : scene.images) hash.add(std::span<const float>(image.image.pixels));
  for (const Shape& s : scene.hidden_shapes) add_shape(hash, s);
  for (const Shape& s : scene.shapes) add_shape(hash, s);
  for (const Object& object : scene.objects) {
    hash.add(object.shapes.size());
    for (const Shape& s : object.shapes) add_shape(hash, s);
  }
  for (const Instance& instance : scene.instances) {
    hash.add(instance.object);
    hash.add(instance.to_world);
  }
  hash.add(scene.camera.camera_to_world);
  hash.add(scene.camera.fov_degrees);
  hash.add(scene.camera.screen);
  hash.add(scene.camera.frame_aspect_ratio);
  return hash.value();
}

std::uint64_t points_fingerprint() {
  Hash hash;
  for (const std::string& name : sampler_names()) {
    for (const std::uint32_t count : {5u, 16u, 64u}) {
      const auto sampler = make_sampler(name, count, 1, count % 4 == 0 ? 4 : 1);
      for (std::uint32_t pixel = 0; pixel < 64; ++pixel) {
        for (std::uint32_t i = 0; i < count; ++i) {
          const FixedPoint p = sampler->sample(pixel, i, 0, SampleDomain::disk);
          hash.add(p.x);
          hash.add(p.y);
        }
      }
    }
  }
  return hash.value();
}

double diagonal(const Scene& scene) {
  Box box = box_of(scene, scene.shapes);
  std::vector<Box> objects;
  for (const Object& object : scene.objects) objects.push_back(box_of(scene, object.shapes));
  for (const Instance& instance : scene.instances) box.add(instance.to_world, objects[instance.object]);
  if (box.low.x > box.high.x) return 0;
  const glm::dvec3 d = box.high - box.low;
  return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

double default_radius(const Scene& scene) {
  const double radius = diagonal(scene) / 20;
  if (!(radius > 0) || !std::isfinite(radius)) return std::numeric_limits<double>::infinity();
  const double digit = std::pow(10.0, std::floor(std::log10(radius)) - 1);
  return std::round(radius / digit) * digit;
}

void set_film(Scene& scene, int width, int height, double pixels) {
  const double aspect = static_cast<double>(scene.film.width) / scene.film.height;
  if (width == 0)
    width = static_cast<int>(std::lround(height > 0 ? height * aspect : std::sqrt(pixels * aspect)));
  if (height == 0) height = static_cast<int>(std::lround(width / aspect));
  scene.film.width = std::max(1, width);
  scene.film.height = std::max(1, height);
}

}  // namespace capcon
