#include <fmt/format.h>

#include <cmath>

#include "base/hash.h"
#include "stability/cases.h"
#include "stability/scenes.h"

namespace capcon::stability {
namespace {

double random(int i, int k) {
  return uniform64(17, i, k);
}

void append(std::vector<glm::dvec3>& points, std::initializer_list<glm::dvec3> more) {
  points.insert(points.end(), more);
}

/// The floor as slivers: long triangles, each 4e-8 or more wide, that fit together along their sides.
std::string sliver_floor() {
  std::vector<glm::dvec3> points;
  double x = -2;
  for (int i = 0; x < 2; ++i) {
    const double next = i % 2 == 0 ? x + 4e-8 : std::min(2.0, x + 0.04);
    append(points, {{x, -2, 0}, {next, -2, 0}, {next, 2, 0}, {x, -2, 0}, {next, 2, 0}, {x, 2, 0}});
    x = next;
  }
  return triangles(points);
}

/// Needles of aspect 1e8 that stand on the floor.
std::string needles() {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 p(3 * random(i, 0) - 1.5, 3 * random(i, 1) - 1.5, 0);
    append(points, {p, p + glm::dvec3(1e-8, 0, 0), p + glm::dvec3(0, 0, 1)});
  }
  return triangles(points);
}

/// Points, lines, and every other triangle of the room twice.
std::string useless() {
  return triangles({{0, 0, 1},
                    {0, 0, 1},
                    {0, 0, 1},
                    {-1, 0, .5},
                    {0, 0, .5},
                    {1, 0, .5},
                    {1, 1, 1},
                    {1, 1, 1},
                    {1, 1, 2}}) +
         parallelogram({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}) + parallelogram({-2, 2, 0}, {4, 0, 0}, {0, 0, 3});
}

/// Other triangles in the planes of the floor and of a wall, and boxes that go through each other and the
/// floor.
std::string interpenetrating() {
  return triangles({{-1.5, -1.5, 0}, {1.7, -1.1, 0}, {.2, 1.3, 0}, {-2, -1, .3}, {-2, 1, .2}, {-2, .4, 2}}) +
         within("Translate .8 .6 .2 Rotate 40 1 1 .3\n" + box({-.4, -.4, -.4}, {.4, .4, .4})) +
         within("Translate -.5 .3 .1 Rotate 10 .2 1 .3\n" + box({-.6, -.3, -.4}, {.4, .6, .3}));
}

/// A million small triangles as a thousand copies of a thousand, on a triangle of 100.
std::string huge_and_tiny() {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 p(0.2 * random(i, 2), 0.2 * random(i, 3), 0.2 * random(i, 4));
    for (int v = 0; v < 3; ++v)
      points.push_back(p +
                       0.01 * glm::dvec3(random(i, 5 + 3 * v), random(i, 6 + 3 * v), random(i, 7 + 3 * v)));
  }
  std::string text = matte(0.6) + triangles({{-100, -100, 0}, {100, -100, 0}, {0, 150, 0}}) +
                     "ObjectBegin \"crumbs\"\n" + triangles(points) + "ObjectEnd\n";
  for (int i = 0; i < 1000; ++i) {
    text += within(fmt::format("Translate {:.6f} {:.6f} 0\nObjectInstance \"crumbs\"\n",
                               8 * random(i, 20) - 4, 8 * random(i, 21) - 4));
  }
  return text;
}

ImageCase occlusion_case(const std::string& name, const std::string& what, const std::string& scene,
                         double radius, double share, double bias, const std::string& reason) {
  return {.group = "geometry",
          .name = name,
          .what = what,
          .scene = scene,
          .job = occlusion(radius),
          .bound = {.tolerance = 1e-4, .share = share, .bias = bias, .reason = reason}};
}

}  // namespace

std::vector<ImageCase> geometry_cases() {
  const std::string edges = "a ray that passes an edge within rounding may go either way";
  std::vector<ImageCase> cases;
  cases.push_back(
      occlusion_case("slivers", "a floor of triangles 4 long and 4e-8 wide",
                     room_camera() + world(room() + within("Translate 0 0 1e-4\n" + sliver_floor())), 1.5,
                     0.005, 1e-3, edges));
  cases.push_back(occlusion_case("needles", "200 needles of aspect 1e8",
                                 room_camera() + world(room() + needles()), 1.5, 0.005, 1e-3, edges));
  cases.push_back(occlusion_case("useless", "points, lines and duplicates among the triangles",
                                 room_camera() + world(room() + useless()), 1.5, 0.005, 1e-3, edges));
  cases.push_back(occlusion_case("interpenetrating", "coplanar triangles, boxes through boxes",
                                 room_camera() + world(room() + interpenetrating()), 1.5, 0.02, 1e-3,
                                 edges + "; where surfaces cut each other it is any ray"));
  cases.push_back(occlusion_case("huge-and-tiny", "a million triangles of 0.01 on one of 100",
                                 camera({0, -3, 1}, {0, 0, 0}, 40) + world(huge_and_tiny()), 0.5, 0.05, 5e-3,
                                 "a hit on the large one is known to 6e-6 of its size, 1e-3 of a small one's "
                                 "(see the ladder of floors)"));
  cases.push_back(occlusion_case(
      "along-axes", "camera rays along axes, in the planes of the floor and of box sides",
      camera({0, -3, 0}, {0, 0, 0}, 40, {}, {0, 0, 1}, 65, 65) +
          world(matte(0.6) + parallelogram({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}) + box({-1, 0, 0}, {0, 1, 1}) +
                box({0, .5, -1}, {1, 1.5, .5})),
      1.5, 0.02, 0.05,
      "the middle row lies in the planes: what it sees is a matter of definition, all else is not"));
  cases.push_back(occlusion_case("grazing", "a floor seen at 1e-5 radians",
                                 camera({0, -4, 4e-5}, {0, 0, 0}, 1e-3) + world(room()), 1.5, 0.15, 5e-3,
                                 "the hit moves by rounding / sin(angle), 0.6 % of its distance"));
  cases.push_back({.group = "geometry",
                   .name = "direct-slivers",
                   .what = "direct light on the floor of slivers",
                   .scene = room_camera() + world(room() + within("Translate 0 0 1e-4\n" + sliver_floor())),
                   .job = direct(),
                   .bound = {.tolerance = 1e-4, .share = 0.002, .bias = 3e-4, .reason = edges}});
  return cases;
}

}  // namespace capcon::stability
