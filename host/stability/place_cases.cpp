#include <fmt/format.h>

#include <glm/trigonometric.hpp>

#include "stability/cases.h"
#include "stability/scenes.h"

namespace capcon::stability {
namespace {

constexpr double kSize = 4;  // of the room
const char* const kReason =
    "the same rays as in the room at its own place: floats are relative to the camera and in units of the "
    "scene";

std::string short_power(double v) {
  return fmt::format("{:.0e}", v);
}

void add(std::vector<ImageCase>& cases, const std::string& name, const std::string& what,
         const Place& place) {
  const std::string scene = room_camera(place) + world(room(), place);
  const auto add_job = [&](const char* prefix, const Job& job, double tolerance, double share) {
    cases.push_back({.group = "scale and place",
                     .name = fmt::format("{}-{}", prefix, name),
                     .what = what,
                     .scene = scene,
                     .job = job,
                     .bound = {.tolerance = tolerance, .share = share, .bias = 1e-4, .reason = kReason}});
  };
  add_job("ao", occlusion(1.5 * place.scale), 1e-4, 0.001);
  add_job("direct", direct(), 1e-4, 0.001);
  add_job("igi", igi(), 1e-4, 0.003);
}

}  // namespace

std::vector<ImageCase> place_cases() {
  std::vector<ImageCase> cases;
  add(cases, "as-it-is", "the room at its own place", {});
  for (const double scale : {1e-6, 1e-3, 1e3, 1e6})
    add(cases, "scaled-" + short_power(scale), "all lengths x " + short_power(scale), {scale, {0, 0, 0}});
  const glm::dvec3 direction(1, 0.7, -0.4);
  for (const double sizes : {1e3, 1e6}) {
    add(cases, "moved-" + short_power(sizes), "moved by " + short_power(sizes) + " of its size",
        {1, sizes * kSize * direction});
  }
  add(cases, "small-and-moved", "lengths x 1e-6, then moved by 1e6 of its size",
      {1e-6, 1e6 * 1e-6 * kSize * direction});
  add(cases, "large-and-moved", "lengths x 1e6, then moved by 1e6 of its size",
      {1e6, 1e6 * 1e6 * kSize * direction});
  for (const double distance : {1e3, 1e6}) {
    const glm::dvec3 at(-.05, .2, .8), towards(0.23, -0.96, 0.22);
    const double fov = 2 * glm::degrees(std::atan(1.6 / (distance * kSize)));
    cases.push_back({.group = "scale and place",
                     .name = "ao-from-afar-" + short_power(distance),
                     .what = "seen from " + short_power(distance) + " of its size",
                     .scene = camera(at + distance * kSize * towards, at, fov) + world(room()),
                     .job = occlusion(1.5),
                     .bound = {.tolerance = 1e-4,
                               .share = 0.001,
                               .bias = 1e-4,
                               .reason = "camera rays start on a plane before the scene, placed in double"}});
  }
  return cases;
}

}  // namespace capcon::stability
