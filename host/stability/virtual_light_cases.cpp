#include <fmt/format.h>

#include "stability/cases.h"
#include "stability/scenes.h"

namespace capcon::stability {
namespace {

/// Three walls that meet at a point, 1000 times as large as the distance of a small lamp from it: VPLs lie as
/// near to what the camera sees. (Of larger triangles floats do not tell such distances: the ladder
/// "near-corner".)
std::string corner(const glm::dvec3& at, double size) {
  const double w = 1000 * size;
  const glm::dvec3 s = at + glm::dvec3(size);
  return matte(0.7) + parallelogram(at, {w, 0, 0}, {0, w, 0}) + parallelogram(at, {0, w, 0}, {0, 0, w}) +
         parallelogram(at, {0, 0, w}, {w, 0, 0}) +
         lamp(fmt::format(
             "Translate {:.17g} {:.17g} {:.17g}\nRotate 54.7 1 -1 0\nShape \"disk\" \"float radius\" {}\n",
             s.x, s.y, s.z, 0.3 * size));
}

ImageCase corner_case(const std::string& name, const std::string& what, const glm::dvec3& at, double size,
                      Clamping clamping, double limit, const ImageBound& bound) {
  GlobalIlluminationJob job = igi(clamping);
  job.limit = limit;
  return {.group = "virtual lights",
          .name = name,
          .what = what,
          .scene = camera(at + size * glm::dvec3(4, 5, 6), at + size * glm::dvec3(.6, .5, .4), 30) +
                   world(corner(at, size)),
          .job = job,
          .bound = bound};
}

}  // namespace

std::vector<ImageCase> virtual_light_cases() {
  std::vector<ImageCase> cases;
  const std::string scene = room_camera() + world(room());
  const auto add = [&](const std::string& name, const std::string& what, Clamping clamping, double limit) {
    GlobalIlluminationJob job = igi(clamping);
    job.limit = limit;
    cases.push_back(
        {.group = "virtual lights",
         .name = name,
         .what = what,
         .scene = scene,
         .job = job,
         .bound = {1e-3, 0.002, 3e-4, "near a VPL 1 / distance^2 magnifies the rounding of positions"}});
  };
  add("geometry-unlimited", "the room without any limit of 1 / distance^2", Clamping::none, 0);
  add("limit-1e-20", "a limit of 1e-20: all by compensation", Clamping::compensate, 1e-20);
  add("limit-1e20", "a limit of 1e20: none by compensation", Clamping::compensate, 1e20);
  const ImageBound close = {1e-3, 0.002, 3e-4, "the device's unit of length is the scene's"};
  cases.push_back(corner_case("corner-1e-6", "VPLs 1e-6 from the corner of the world that the camera sees",
                              {0, 0, 0}, 1e-6, Clamping::none, 0, close));
  cases.push_back(corner_case("corner-1e-6-compensated", "the same with compensation at a limit of 1e10",
                              {0, 0, 0}, 1e-6, Clamping::compensate, 1e10, close));
  return cases;
}

}  // namespace capcon::stability
