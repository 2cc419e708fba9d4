#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstring>

#include "render/renderer.h"
#include "stability/checks.h"
#include "stability/scenes.h"

namespace capcon::stability {
namespace {

Image render(const Place& place, const std::string& name, const Job& job, const Workshop& workshop) {
  const ImageCase c{.group = "scale and place",
                    .name = name,
                    .what = "",
                    .scene = room_camera(place) + world(room(), place),
                    .job = job};
  const Scene scene = read_case(c, workshop);
  return Renderer(scene, renderer_options(job, workshop)).render(job).image;
}

Check run(const std::string& name, const std::function<Job(double)>& job_at, const Workshop& workshop) {
  const auto start = std::chrono::steady_clock::now();
  Check check;
  check.group = "scale and place";
  check.name = name;
  check.what = "lengths x 2^20 and x 2^-20";
  check.bound = "the same bits";
  check.reason = "the device's unit of length is a power of 2 times the scene's";
  const Image own = render({}, name + "-1", job_at(1), workshop);
  for (const int power : {20, -20}) {
    const double scale = std::ldexp(1.0, power);
    const Image other =
        render({scale, glm::dvec3(0)}, fmt::format("{}-2^{}", name, power), job_at(scale), workshop);
    for (std::size_t i = 0; i < own.pixels.size(); ++i) {
      ++check.values;
      if (std::memcmp(&own.pixels[i], &other.pixels[i], 4) != 0) ++check.beyond;
    }
  }
  check.measured = fmt::format("{} values differ", check.beyond);
  check.passed = check.beyond == 0;
  check.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return check;
}

}  // namespace

std::vector<Task> bit_tasks(const Workshop& workshop) {
  std::vector<Task> tasks;
  const auto add = [&](const std::string& name, const std::function<Job(double)>& job) {
    tasks.push_back({"scale and place", name, [=] { return run(name, job, workshop); }});
  };
  add("ao-bits", [](double scale) { return occlusion(1.5 * scale); });
  add("direct-bits", [](double) { return direct(); });
  add("igi-bits", [](double) { return igi(); });
  return tasks;
}

}  // namespace capcon::stability
