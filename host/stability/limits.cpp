#include <fmt/format.h>

#include <chrono>

#include "stability/checks.h"
#include "stability/scenes.h"

namespace capcon::stability {
namespace {

/// Scenes that grow ever harder: the first rung of which too many pixels are off is where floats end.
struct Ladder {
  std::string name, what;
  std::vector<double> rungs;
  std::function<ImageCase(double)> at;
  double must_hold;  ///< the last rung that has to be right
  std::string reason;
};

ImageCase case_of(const std::string& scene, const Job& job, double tolerance) {
  return {.group = "limits",
          .name = "",
          .what = "",
          .scene = scene,
          .job = job,
          .bound = {.tolerance = tolerance, .share = 0.02, .bias = 2e-3, .reason = ""}};
}

const std::string kFarFloor = parallelogram({-500, -500, 0}, {1000, 0, 0}, {0, 1000, 0});

std::vector<Ladder> ladders() {
  return {
      {"small-thing",
       "a room of this size at distance 1 from the camera, in a scene of 1000",
       {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7},
       [](double size) {
         // Moved, so that no coordinate is small.
         const Place place{size, {.55, .83, .61}};
         const glm::dvec3 at = place.offset + size * glm::dvec3(-.05, .2, .8);
         return case_of(
             camera(at + glm::dvec3(.2, -.97, .14), at, 60 * 4 * size) +
                 world(matte(.5) + kFarFloor +
                       within(fmt::format("Translate .55 .83 .61 Scale {0} {0} {0}\n", size) + room())),
             occlusion(1.5 * size), 1e-4);
       },
       1e-3,
       "a position is known to 6e-8 of its distance from the camera: a 1e-3 room's to 1e-4 of its size"},
      {"narrow-gap",
       "a plate at this height above a floor 3 away",
       {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8},
       [](double gap) {
         return case_of(
             camera({.13, -2.7, 1.4}, {.1, .2, 0}, 40) +
                 world(matte(.5) + within("Translate 0 0 .2871\n" +
                                          parallelogram({-50, -50, 0}, {100, 0, 0}, {0, 100, 0}) +
                                          within(fmt::format("Translate 0 0 {}\n", gap) +
                                                 parallelogram({-1, -1, 0}, {2, 0, 0}, {0, 2, 0})))),
             occlusion(1), 1e-4);
       },
       1e-4,
       "floor and plate are apart by more than the rounding of both"},
      {"small-decal",
       "a square of this size in the plane of a floor of 100, tilted",
       {1e1, 1, 1e-1, 1e-2, 1e-3, 1e-4},
       [](double size) {
         return case_of(camera(size * glm::dvec3(.3, -3, 2), {0, 0, 0}, 30) +
                            world(matte(.5) + within("Rotate 20 .3 1 .2 Translate 0 0 .01\n" +
                                                     parallelogram({-50, -50, 0}, {100, 0, 0}, {0, 100, 0}) +
                                                     parallelogram({-size, -size, 0}, {2 * size, 0, 0},
                                                                   {0, 2 * size, 0}))),
                        occlusion(1), 1e-4);
       },
       1e-1,
       "a distance within its own rounding is no hit"},
      {"large-floor",
       "a room on a floor of this size, as one quadrilateral",
       {1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7},
       [](double size) {
         return case_of(room_camera() + world(matte(.6) +
                                              parallelogram({-size, -size, 0}, {2 * size, .3 * size, 0},
                                                            {-.3 * size, 2 * size, 0}) +
                                              within("Translate 0 0 1e-3\n" + room())),
                        occlusion(1.5), 1e-4);
       },
       1e3,
       "a distance to a triangle is known to 1e-7 of the triangle's size: 1e-3 above a floor of 1e3 is "
       "not in it"},
      {"near-corner",
       "so near to where three squares of 4 meet, seen from as near",
       {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7},
       [](double size) {
         const glm::dvec3 at(.31, .17, .23);
         return case_of(
             camera(at + size * glm::dvec3(4, 5, 6), at + size * glm::dvec3(.6, .5, .4), 30) +
                 world(matte(.7) +
                       within("Translate .31 .17 .23 Rotate 20 .3 .2 1 Translate -.31 -.17 -.23\n" +
                              parallelogram(at, {4, 0, 0}, {0, 4, 0}) +
                              parallelogram(at, {0, 4, 0}, {0, 0, 4}) +
                              parallelogram(at, {0, 0, 4}, {4, 0, 0}))),
             occlusion(5 * size), 1e-4);
       },
       1e-4,
       "a distance to a triangle below 1e-6 of the triangle's size is not told from none"},
      {"large-sphere-light",
       "a sphere light of this radius that stands on a floor",
       {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6},
       [](double radius) {
         return case_of(
             stage_camera() +
                 world(stage() + within(fmt::format(
                                     "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1] \"bool twosided\" true\n"
                                     "Translate .4 .2 {0}\nShape \"sphere\" \"float radius\" {0}\n",
                                     radius))),
             direct(), 1e-3);
       },
       1e2,
       "near the touching point the light's distance is below the rounding of its radius"}};
}

Check run(const Ladder& ladder, const Workshop& workshop) {
  const auto start = std::chrono::steady_clock::now();
  Check check;
  check.group = "limits";
  check.name = ladder.name;
  check.what = ladder.what;
  check.bound = fmt::format("right down to {:g} at least", ladder.must_hold);
  if (ladder.rungs.back() > ladder.rungs.front())
    check.bound = fmt::format("right up to {:g} at least", ladder.must_hold);
  check.reason = ladder.reason;
  check.passed = true;
  std::string last = "none";
  bool ended = false;
  for (const double rung : ladder.rungs) {
    ImageCase c = ladder.at(rung);
    c.name = fmt::format("{}-{:.0e}", ladder.name, rung);
    const Check one = run_case(c, workshop);
    check.values += one.values;
    check.non_finite += one.non_finite;
    const double share = 100.0 * static_cast<double>(one.beyond) / static_cast<double>(one.values);
    if (one.passed && !ended) {
      last = fmt::format("{:g}", rung);
    } else if (!ended) {
      ended = true;
      check.measured = fmt::format("right to {}; at {:g} {:.1f} % of pixels are off ({})", last, rung, share,
                                   one.measured);
      check.command = one.command;
      const bool down = ladder.rungs.back() < ladder.rungs.front();
      if (down ? rung >= ladder.must_hold : rung <= ladder.must_hold) check.passed = false;
    }
  }
  if (!ended) check.measured = fmt::format("right to {}, the last tried", last);
  check.passed = check.passed && check.non_finite == 0;
  check.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return check;
}

}  // namespace

std::vector<Task> limit_tasks(const Workshop& workshop) {
  std::vector<Task> tasks;
  for (const Ladder& ladder : ladders())
    tasks.push_back({"limits", ladder.name, [=] { return run(ladder, workshop); }});
  return tasks;
}

}  // namespace capcon::stability
