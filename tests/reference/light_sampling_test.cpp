// Points on lights against their densities, and where docs/direct.md puts them.
#include "reference/light_sampling.h"

#include <gtest/gtest.h>

#include "reference/chi_square.h"
#include "reference/geometry.h"
#include "reference/lighting.h"

namespace capcon {
namespace {

using reference::Geometry;
using reference::LightSampling;
using std::numbers::pi;
using test::kFloor;
using test::lamp;

Scene scene_of(const std::string& text, const Image* map) {
  Scene scene = test::parse_world(text, {true, true, true});
  if (!map) return scene;
  scene.images.push_back({"map", *map});
  for (Entity& light : scene.lights) light.image = 0;
  return scene;
}

/// Lights of a scene, seen from the origin, which faces +z. Environments get the map.
struct Lit {
  explicit Lit(const std::string& text, const Image* map = nullptr) : scene(scene_of(text, map)) {}
  Scene scene;
  Geometry geometry{scene};
  LightSampling lights{scene, geometry.primitives};

  std::optional<glm::dvec3> sample(const glm::dvec2& u, const glm::dvec3& from = glm::dvec3(0)) const {
    const auto s = lights.sample(0, from, {0, 0, 1}, u);
    if (!s) return {};
    return s->direction;
  }
  /// What light 0 gives and how densely it is sampled in a direction, by tracing a ray.
  reference::LightMet met(const glm::dvec3& direction) const {
    const Light& light = lights.lights().values.at(0);
    if (light.kind == LightKind::environment) return lights.environment(0, {0, 0, 1}, direction);
    const reference::Ray ray(glm::dvec3(0), direction);
    const auto hit = geometry.tree.closest(ray);
    if (!hit || lights.of_primitive(hit->primitive) != 0) return {};
    return lights.meet(0, hit->primitive, ray, hit->t);
  }
};

/// `axis`: about which the bins lie. Ellipsoids emit as triangles within them: their densities agree less
/// well.
void expect_as_dense(const std::string& what, const Lit& lit, const glm::dvec3& axis,
                     bool ellipsoid = false) {
  double reach = 0;
  for (int i = 0; i < 64 * 64; ++i) {
    const auto w = lit.sample({(i % 64 + 0.5) / 64, (i / 64 + 0.5) / 64});
    if (w) reach = std::max(reach, std::acos(std::min(1.0, glm::dot(*w, glm::normalize(axis)))));
  }
  const test::ChiSquare c = test::chi_square(
      glm::normalize(axis), [&](const glm::dvec2& u, double) { return lit.sample(u); },
      [&](const glm::dvec3& w) { return lit.met(w).pdf; }, std::min(pi, 1.1 * reach));
  EXPECT_LT(c.sigmas, 4) << what;
  EXPECT_NEAR(c.integral + c.nothing, 1, 0.005) << what;
  EXPECT_EQ(c.nothing > 0, ellipsoid) << what;  // its far triangles, which face away
  // The sample's own density is that of the ray which meets the light there.
  for (const glm::dvec2 u : {glm::dvec2(0.3, 0.2), {0.9, 0.6}, {0.45, 0.8}}) {
    const auto s = lit.lights.sample(0, glm::dvec3(0), {0, 0, 1}, u);
    if (!s) continue;
    const reference::LightMet met = lit.met(s->direction);
    EXPECT_NEAR(s->pdf / met.pdf, 1, ellipsoid ? 0.05 : 1e-9) << what;
    EXPECT_EQ(s->radiance, met.radiance) << what;
  }
}

TEST(LightSampling, SamplesAreAsDenseAsRaysThatMeetTheLight) {
  const struct {
    const char* name;
    glm::dvec3 axis;
    std::string shape;
  } cases[] = {
      {"disk", {0, 0, 1}, "Translate 0 0 2 Shape \"disk\""},
      {"oblique disk", {1, 0, 1}, "Translate 1 0 1 Rotate 70 0 1 0 Shape \"disk\""},
      {"ring of an ellipse",
       {0, 1, 1},
       "Translate 0 1 1 Scale 2 1 1 Shape \"disk\" \"float innerradius\" .6"},
      {"sphere far away", {3, 4, 5}, "Translate 30 40 50 Shape \"sphere\" \"float radius\" 1"},
      {"sphere", {0, 1, 1}, "Translate 0 1 1 Shape \"sphere\" \"float radius\" .7"},
      {"sphere nearby", {0, 0, 1}, "Translate 0 0 1.001 Shape \"sphere\""},
      {"sphere from inside", {0, 1, 1}, "Translate 0 0.3 0.4 Shape \"sphere\""},
      {"ellipsoid", {0, 1, 2}, "Translate 0 1 2 Scale 1 .5 .2 Shape \"sphere\""},
      {"rectangle",
       {1, 0, 2},
       "Shape \"trianglemesh\" \"point3 P\" [0 0 2 2 0 2 2 1 2 0 1 2] \"integer indices\" [0 1 2 0 2 3]"},
      {"triangles",
       {1, 0, 2},
       "Shape \"trianglemesh\" \"point3 P\" [0 0 2 2 0 3 2 1 2 0 1 2.5 -1 -1 1] \"integer indices\" [0 1 2 0 "
       "1 1 0 2 3 0 3 4]"},
  };
  for (const auto& c : cases) {
    const std::string name = c.name;
    const bool ellipsoid = name == "ellipsoid", inside = name == "sphere from inside";
    const std::string turn = inside ? "ReverseOrientation " : "";
    const std::string sides = inside || ellipsoid ? "" : "\"bool twosided\" true ";
    expect_as_dense(name, Lit(lamp(turn + c.shape, sides)), c.axis, ellipsoid);
  }
}

Image stiff_map(int width, int height) {
  Image map(width, height, 3);
  for (float& v : map.pixels) v = 0.1f;
  for (int c = 0; c < 3; ++c) map.at(width / 3, height / 4, c) = 500;
  return map;
}

TEST(LightSampling, EnvironmentsAreAsDenseAsTheySay) {
  expect_as_dense("constant", Lit("LightSource \"infinite\" \"rgb L\" [1 1 1]"), {0, 0, 1});
  const Image lat_long = stiff_map(24, 12), octahedral = stiff_map(16, 16);
  const Lit turned("Rotate 50 1 2 3 LightSource \"infinite\" \"string mapname\" \"map\"", &lat_long);
  expect_as_dense("lat-long", turned, *turned.sample({0.5, 0.5}));
  const Lit square("Rotate 50 1 2 3 LightSource \"infinite\" \"string filename\" \"map\"", &octahedral);
  expect_as_dense("octahedral", square, *square.sample({0.5, 0.5}));
}

TEST(LightSampling, PointsAreWhereTheyAreDocumented) {
  const auto expect_at = [](const std::string& text, const glm::dvec2& u, const glm::dvec3& place,
                            double tolerance = 1e-12) {
    const Lit lit(text);
    const auto s = lit.lights.sample(0, glm::dvec3(0), {0, 0, 1}, u);
    ASSERT_TRUE(s) << text;
    EXPECT_LT(glm::distance(s->distance * s->direction, place), tolerance)
        << text << " " << u.x << " " << u.y;
  };
  const std::string two = "\"bool twosided\" true ";
  // (1, 1/2) of the square is (1, 0) of the disk, the centre the centre; a ring's inner rim is r = 0.
  expect_at(lamp("Translate 3 0 2 Scale 2 1 1 Shape \"disk\"", two), {1, 0.5}, {5, 0, 2});
  expect_at(lamp("Translate 3 0 2 Scale 2 1 1 Shape \"disk\"", two), {0.5, 0.5}, {3, 0, 2});
  expect_at(lamp("Translate 3 0 2 Scale 2 1 1 Shape \"disk\"", two), {0.5, 0.75}, {3, 0.5, 2});
  expect_at(lamp("Translate 3 0 2 Shape \"disk\" \"float innerradius\" 0.5", two), {0.75, 0.5},
            {3 + std::sqrt(0.25 + 0.75 / 4), 0, 2});
  // The nearest point of a sphere, and the tangent: sin = 1/2 in frame(z), whose first axis is x.
  const std::string ball = lamp("Translate 0 0 4 Shape \"sphere\" \"float radius\" 2");
  expect_at(ball, {0.5, 0.5}, {0, 0, 2});
  expect_at(ball, {1, 0.5}, std::sqrt(12) * glm::dvec3(0.5, 0, std::sqrt(0.75)), 1e-7);
  // From inside: u.y = 1/4 is z = 1/2, u.x = 1/4 the azimuth of y.
  expect_at(lamp("ReverseOrientation Translate 0 0.1 0 Shape \"sphere\" \"float radius\" 2"), {0.25, 0.25},
            {0, 0.1 + std::sqrt(3), 1});
  // Triangles of areas 1 and 3: u.x = 5/8 is the second at 1/2; y < x: y /= 2, x -= y.
  expect_at(lamp("Shape \"trianglemesh\" \"point3 P\" [0 0 1 2 0 1 0 1 1  5 0 1 8 0 1 5 2 1] \"integer "
                 "indices\" [0 1 2 3 4 5]",
                 two),
            {0.625, 0.25}, {5 + 3 * 0.375, 2 * 0.125, 1});
  // u.x = 1/4 starts the second; y > x: x /= 2, y -= x.
  expect_at(lamp("Shape \"trianglemesh\" \"point3 P\" [0 0 1 2 0 1 0 1 1  5 0 1 8 0 1 5 2 1] \"integer "
                 "indices\" [0 1 2 3 4 5]",
                 two),
            {0.25, 0.5}, {5, 1, 1});
}

TEST(LightSampling, DomainsAreThoseOfTheTable) {
  const auto domain = [](const std::string& text, const glm::dvec3& from = glm::dvec3(0)) {
    return Lit(text).lights.domain(0, from);
  };
  const std::string ball = lamp("Translate 0 0 4 Shape \"sphere\" \"float radius\" 2");
  EXPECT_EQ(domain(lamp("Shape \"disk\"")), SampleDomain::disk);
  EXPECT_EQ(domain(ball), SampleDomain::disk);
  EXPECT_EQ(domain(ball, {0, 0, 3}), SampleDomain::cylinder);
  EXPECT_EQ(domain("LightSource \"infinite\" \"rgb L\" [1 1 1]"), SampleDomain::disk);
  EXPECT_EQ(domain(lamp(kFloor)), SampleDomain::square);
  const Image map = stiff_map(4, 2);
  EXPECT_EQ(Lit("LightSource \"infinite\" \"string mapname\" \"map\"", &map).lights.domain(0, glm::dvec3(0)),
            SampleDomain::cylinder);
}

TEST(LightSampling, SidesThatDoNotEmitGiveNothing) {
  const auto gives = [](const std::string& shape, const std::string& parameters = "") {
    const Lit lit(lamp(shape, parameters));
    return lit.lights.sample(0, glm::dvec3(0), {0, 0, 1}, {0.3, 0.6}).has_value();
  };
  const std::string two = "\"bool twosided\" true ", turn = "ReverseOrientation ";
  const std::string disk = "Translate 0 0 2 Shape \"disk\"", ball = "Translate 0 0 2 Shape \"sphere\"";
  const std::string around = "Shape \"sphere\"", sheet = "Translate 0 0 2 " + kFloor;
  for (const std::string& s : {disk, sheet, around}) {  // they face up, or out
    EXPECT_FALSE(gives(s)) << s;
    EXPECT_TRUE(gives(turn + s)) << s;
    EXPECT_TRUE(gives(s, two)) << s;
  }
  EXPECT_TRUE(gives(ball));
  EXPECT_FALSE(gives(turn + ball));
  EXPECT_TRUE(gives(turn + ball, two));
}

}  // namespace
}  // namespace capcon
