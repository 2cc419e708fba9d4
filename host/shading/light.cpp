#include "shading/light.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "shading/area_light.h"
#include "shading/colours.h"
#include "shading/scene_bounds.h"
#include "shading/spectrum.h"

namespace capcon {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Orthogonal part of a matrix, which may mirror: Gram-Schmidt in the order z, x, y. `exact` is false when
/// more than a common scale was lost.
glm::dmat3 orthogonal(const glm::dmat3& m, bool& exact) {
  const glm::dvec3 z = glm::normalize(m[2]);
  const glm::dvec3 x = glm::normalize(m[0] - glm::dot(m[0], z) * z);
  const glm::dvec3 y = glm::determinant(m) < 0 ? glm::cross(x, z) : glm::cross(z, x);
  const glm::dmat3 result(x, y, z);
  const double scale = glm::length(m[2]);
  exact = true;
  for (int column = 0; column < 3; ++column)
    exact = exact && glm::distance(m[column], scale * result[column]) <= 1e-6 * scale;
  return result;
}

glm::dvec3 read_point(const Parameters& parameters, const std::string& name, const glm::dvec3& fallback) {
  const std::vector<double>* numbers = parameters.numbers(name);
  if (!numbers) return fallback;
  if (numbers->size() != 3)
    throw InputError(find_entry(parameters, name)->place, fmt::format("\"{}\" must be one point", name));
  return {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

class LightReader {
 public:
  explicit LightReader(const Scene& scene) : scene_(scene), bounds_(scene_bounds(scene)) {}

  Lights read() {
    lights_.of_shape.assign(scene_.shapes.size(), -1);
    for (std::size_t i = 0; i < scene_.shapes.size(); ++i) {
      if (add_shape(scene_.shapes[i], false))
        lights_.of_shape[i] = static_cast<int>(lights_.values.size()) - 1;
    }
    for (const Shape& shape : scene_.hidden_shapes) add_shape(shape, true);
    for (const Entity& entity : scene_.lights) add_light(entity);
    if (lights_.values.empty())
      lights_.warnings.push_back(scene_.name +
                                 ": the scene has no light, and direct lighting of it is black");
    return std::move(lights_);
  }

 private:
  void warn(const SourcePlace& place, const std::string& sentence) {
    const std::string warning = one_line(place.str() + ": " + sentence);
    if (lights_.warnings.empty() || lights_.warnings.back() != warning) lights_.warnings.push_back(warning);
  }

  /// Keeps a light unless it is black.
  bool add(Light light, const SourcePlace& place) {
    if (!(light.power.x + light.power.y + light.power.z > 0)) {
      warn(place, "this light emits nothing and is left out");
      lights_.triangles.resize(lights_.triangles.size() - light.triangle_count);
      lights_.areas.resize(lights_.triangles.size());
      return false;
    }
    lights_.values.push_back(std::move(light));
    return true;
  }

  /// The colour `name` times "scale", which was a colour and is a number in pbrt-v4.
  static glm::dvec3 scaled(const Parameters& parameters, const std::string& name) {
    return read_colour(parameters, name, ColourUse::emission, glm::dvec3(1)) *
           read_colour(parameters, "scale", ColourUse::emission, glm::dvec3(1));
  }

  bool add_shape(const Shape& shape, bool hidden) {
    if (shape.area_light < 0) return false;
    const Entity& entity = scene_.area_lights[shape.area_light];
    if (entity.type != "diffuse" && entity.type != "area") {
      warn(entity.place, fmt::format("area lights of the kind \"{}\" are left out", entity.type));
      return false;
    }
    const Parameters& parameters = entity.parameters;
    std::string remark;
    Light light = shape_of_light(scene_, shape, lights_, remark);
    light.hidden = hidden;
    if (!remark.empty()) warn(shape.place, "of this light: " + remark);
    if (find_entry(parameters, "filename")) warn(entity.place, "images on area lights are left out");
    light.radiance = scaled(parameters, "L");
    light.two_sided = parameters.boolean("twosided", false);
    const double sides = light.two_sided ? 2 : 1;
    // pbrt-v4: "power" is what the whole shape emits, for L of luminance 1.
    if (const double power = read_number(parameters, "power", 0, 0); power > 0 && light.area > 0)
      light.radiance *= power / (kPi * light.area * sides);
    light.power = light.radiance * kPi * light.area * sides;
    return add(std::move(light), shape.place);
  }

  void add_light(const Entity& entity) {
    if (entity.type == "infinite" || entity.type == "exinfinite") return environment(entity);
    if (entity.type == "distant") return distant(entity);
    if (entity.type == "point") return point(entity);
    if (entity.type == "spot" || entity.type == "goniometric" || entity.type == "projection") {
      warn(entity.place,
           fmt::format("this {} light is a point light that shines in all directions", entity.type));
      return point(entity);
    }
    warn(entity.place, fmt::format("lights of the kind \"{}\" are left out", entity.type));
  }

  void point(const Entity& entity) {
    const Parameters& parameters = entity.parameters;
    Light light;
    light.kind = LightKind::point;
    light.radiance = scaled(parameters, "I");
    if (const double power = read_number(parameters, "power", 0, 0); power > 0)
      light.radiance *= power / (4 * kPi);
    const glm::dvec3 from = read_point(parameters, "from", glm::dvec3(0));
    light.position = glm::dvec3(entity.to_world * glm::dvec4(from, 1));
    light.power = 4 * kPi * light.radiance;
    add(light, entity.place);
  }

  void distant(const Entity& entity) {
    const Parameters& parameters = entity.parameters;
    const glm::dvec3 from = read_point(parameters, "from", glm::dvec3(0));
    const glm::dvec3 to = read_point(parameters, "to", glm::dvec3(0, 0, 1));
    const glm::dvec3 way = glm::dmat3(entity.to_world) * (to - from);
    if (!(glm::length(way) > 0))
      throw InputError(entity.place, "a distant light's \"from\" and \"to\" must differ");
    Light light;
    light.kind = LightKind::distant;
    light.normal = glm::normalize(way);
    light.radiance = scaled(parameters, "L");
    if (const double wanted = read_number(parameters, "illuminance", 0, 0); wanted > 0)
      light.radiance *= wanted;
    light.power = kPi * bounds_.radius * bounds_.radius * light.radiance;
    if (bounds_.radius == 0) light.power = light.radiance;  // nothing to light, yet no black light
    add(light, entity.place);
  }

  void environment(const Entity& entity) {
    const Parameters& parameters = entity.parameters;
    Light light;
    light.kind = LightKind::environment;
    light.radiance = scaled(parameters, "L");
    bool exact = true;
    const glm::dmat3 to_world = orthogonal(glm::dmat3(entity.to_world), exact);
    light.to_light = glm::transpose(to_world);
    glm::dvec3 integral = 4 * kPi * light.radiance;
    double illuminance = kPi;  // of a surface that faces up, by radiance 1
    if (entity.image >= 0) {
      if (!exact) warn(entity.place, "of this environment's transform only the rotation is kept");
      const Image& image = scene_.images[entity.image].image;
      light.environment = static_cast<int>(lights_.environments.size());
      lights_.environments.push_back({entity.image, tabulate_environment(image, map_of(entity, image))});
      const EnvironmentTable& table = lights_.environments.back().table;
      integral = table.integral * light.radiance;
      illuminance = upward_illuminance(image, table.map);
      say_mended(entity, image);
    }
    if (const double wanted = read_number(parameters, "illuminance", 0, 0); wanted > 0 && illuminance > 0) {
      light.radiance *= wanted / illuminance;
      integral *= wanted / illuminance;
    }
    light.power = kPi * bounds_.radius * bounds_.radius * integral;
    if (bounds_.radius == 0) light.power = integral;
    const int used = light.environment;
    if (!add(std::move(light), entity.place) && used >= 0) lights_.environments.pop_back();
  }

  /// pbrt-v2 and v3 name lat-long maps by "mapname", pbrt-v4 octahedral ones by "filename".
  SphereMap map_of(const Entity& entity, const Image& image) {
    const bool is_new = find_entry(entity.parameters, "filename") != nullptr;
    if (is_new && image.width == image.height) return SphereMap::octahedral;
    if (is_new)
      warn(entity.place, fmt::format("an image of {} x {} is no equal-area map and is read as a lat-long one",
                                     image.width, image.height));
    return SphereMap::lat_long;
  }

  void say_mended(const Entity& entity, const Image& image) {
    std::size_t bad = 0;
    for (const float value : image.pixels) bad += !(value >= 0 && std::isfinite(value));
    if (bad > 0)
      warn(entity.place,
           fmt::format("{} values of this environment are negative or not finite and are 0", bad));
  }

  /// Illuminance by the image's upper half of a surface whose normal is the map's +z, in luminance.
  static double upward_illuminance(const Image& image, SphereMap map) {
    double sum = 0;
    for (int y = 0; y < image.height; ++y) {
      const double solid_angle = texel_solid_angle(map, image.width, image.height, y);
      for (int x = 0; x < image.width; ++x) {
        const double z = direction_of_square(map, {(x + 0.5) / image.width, (y + 0.5) / image.height}).z;
        if (z > 0) sum += luminance(sphere_texel(map, image, x, y)) * z * solid_angle;
      }
    }
    return sum;
  }

  const Scene& scene_;
  BoundingSphere bounds_;
  Lights lights_;
};

}  // namespace

Lights read_lights(const Scene& scene) {
  return LightReader(scene).read();
}

glm::dvec3 environment_radiance(const Scene& scene, const Lights& lights, const Light& light,
                                const glm::dvec3& direction) {
  if (light.environment < 0) return light.radiance;
  const Environment& environment = lights.environments[light.environment];
  return light.radiance * sphere_lookup(environment.table.map, scene.images[environment.image].image,
                                        light.to_light * direction);
}

}  // namespace capcon
