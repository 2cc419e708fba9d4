#include "cli/virtual_lights_option.h"

#include <fmt/format.h>

#include <filesystem>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/file.h"
#include "plot/picture_file.h"
#include "reference/primitives.h"
#include "reference/tree.h"
#include "render/ray_caster.h"
#include "render/renderer_state.h"
#include "study/virtual_light_list.h"
#include "study/virtual_light_picture.h"

namespace capcon::cli {
namespace {

constexpr double kShort = 1 - 1.0 / 4096;  // of the way to a VPL: its own surface does not hide it

std::vector<bool> seen_on_device(Renderer& renderer, const glm::dvec3& eye,
                                 std::span<const glm::dvec3> points) {
  std::vector<DeviceRay> rays;
  for (const glm::dvec3& p : points) {
    const Placement& placement = renderer.state().placement;
    const double distance = glm::length(p - eye);
    rays.push_back({glm::vec3(placement.to_device(eye)),
                    static_cast<float>(placement.scale * distance * kShort),
                    glm::vec3((p - eye) / distance)});
  }
  RayCaster caster(renderer.state(), rays);
  caster.cast(true);
  std::vector<bool> seen;
  for (const DeviceHit& hit : caster.hits()) seen.push_back(hit.primitive == 0xffffffffu);
  return seen;
}

std::vector<bool> seen_on_reference(const Scene& scene, const glm::dvec3& eye,
                                    std::span<const glm::dvec3> points) {
  const reference::Primitives primitives(scene);
  const reference::Tree tree(primitives);
  std::vector<bool> seen;
  for (const glm::dvec3& p : points) {
    const double distance = glm::length(p - eye);
    seen.push_back(!tree.occluded(reference::Ray(eye, (p - eye) / distance), distance * kShort));
  }
  return seen;
}

void write_file_of(const std::string& path, const Scene& scene, const VirtualLights& lights,
                   const Image& image, const SeenFromEye& seen) {
  const auto extension = std::filesystem::path(path).extension();
  if (extension == ".csv") return write_file(path, virtual_lights_csv(lights));
  if (extension == ".json") return write_file(path, virtual_lights_json(lights));
  const View view = make_view(scene.camera, image.width, image.height);
  const LightPicture picture(image, lights, light_dots(lights, view, image.width, image.height, seen));
  plot::write_picture(
      path, picture.width(), picture.height(), [&](plot::Canvas& c) { picture.draw(c); }, 1);
}

}  // namespace

bool is_light_picture(const std::string& path) {
  return std::filesystem::path(path).extension() == ".png";
}

void check_light_file(const std::string& path, const Job& job) {
  if (!std::holds_alternative<GlobalIlluminationJob>(job))
    throw InputError("--show-virtual-lights is for --integrator igi");
  const auto extension = std::filesystem::path(path).extension();
  if (extension != ".png" && extension != ".csv" && extension != ".json") {
    throw InputError(fmt::format(
        "--show-virtual-lights {}: the name must end in .png (a picture), .csv or .json (a list)", path));
  }
  check_writable(path);
}

void write_lights(const std::string& path, const Scene& scene, const GlobalIlluminationJob& job,
                  const Image& image, Renderer& renderer) {
  write_file_of(path, scene, renderer.virtual_lights(job), image,
                [&](const glm::dvec3& eye, std::span<const glm::dvec3> points) {
                  return seen_on_device(renderer, eye, points);
                });
}

void write_lights(const std::string& path, const Scene& scene, const GlobalIlluminationJob& job,
                  const Image& image, const Reference& reference) {
  write_file_of(path, scene, reference.trace_virtual_lights(job), image,
                [&](const glm::dvec3& eye, std::span<const glm::dvec3> points) {
                  return seen_on_reference(scene, eye, points);
                });
}

}  // namespace capcon::cli
