#include "study/virtual_light_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/vec4.hpp>
#include <nlohmann/json.hpp>

#include "plot/raster_canvas.h"
#include "study/virtual_light_list.h"

namespace capcon {
namespace {

constexpr int kSize = 100;

/// At the origin, looking along z, 90 degrees: at distance d a film of 100 pixels is 2 d wide.
View along_z() {
  return {{0, 0, 0}, {-1, 1, 1}, {0.02, 0, 0}, {0, -0.02, 0}};
}

VirtualLight light_at(const glm::dvec3& position, double flux, std::uint32_t bounce = 1) {
  VirtualLight light;
  light.position = position;
  light.normal = {0, 0, -1};
  light.flux = glm::dvec3(flux);
  light.bounce = bounce;
  return light;
}

/// Two sets: pixels (25, 75) and (50, 50); the second one strong. Behind the eye, off the film, turned away:
/// none.
VirtualLights known_lights() {
  VirtualLights lights;
  lights.lights = {light_at({-1, -1, 2}, 1), light_at({0, 0, -3}, 1), light_at({5, 0, 2}, 1),
                   light_at({0, 0, 4}, 4, 2)};
  lights.lights.push_back(light_at({1, 1, 4}, 1));
  lights.lights.back().normal = {0, 0, 1};
  lights.first = {0, 3, 5};
  return lights;
}

std::vector<bool> all_seen(const glm::dvec3&, std::span<const glm::dvec3> points) {
  return std::vector<bool>(points.size(), true);
}

TEST(VirtualLightPicture, PointsLieWhereTheCameraSeesThem) {
  const auto place = on_film(along_z(), {-1, -1, 2});
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->x, 25, 1e-12);
  EXPECT_NEAR(place->y, 75, 1e-12);
  EXPECT_FALSE(on_film(along_z(), {0, 0, -1}));
  // A camera of the scene's kind, upright: the same rays as make_view's.
  Camera camera;
  camera.fov_degrees = 60;
  const View view = make_view(camera, 80, 60);
  const glm::dvec3 through = view.eye + 7.0 * (view.corner + 12.5 * view.across + 40.25 * view.down);
  EXPECT_NEAR(on_film(view, through)->x, 12.5, 1e-9);
  EXPECT_NEAR(on_film(view, through)->y, 40.25, 1e-9);
}

TEST(VirtualLightPicture, OnlyWhatIsInViewHasADot) {
  const auto dots = light_dots(known_lights(), along_z(), kSize, kSize, all_seen);
  ASSERT_EQ(dots.size(), 2u);
  EXPECT_NEAR(dots[0].place.x, 50, 1e-12);  // the strong one first
  EXPECT_EQ(dots[0].set, 1u);
  EXPECT_EQ(dots[0].bounce, 2u);
  EXPECT_NEAR(dots[0].strength, 4 / 1.6, 1e-12);
  EXPECT_EQ(dots[1].set, 0u);
  EXPECT_GT(dot_radius(dots[0], kSize), dot_radius(dots[1], kSize));
  // Something hides what is farther than 3.
  const auto near = [](const glm::dvec3&, std::span<const glm::dvec3> points) {
    std::vector<bool> seen;
    for (const glm::dvec3& p : points) seen.push_back(p.z < 3);
    return seen;
  };
  const auto left = light_dots(known_lights(), along_z(), kSize, kSize, near);
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].set, 0u);
}

TEST(VirtualLightPicture, DotsOfASetsColourOnAGreyRoom) {
  Image room(kSize, kSize, 3);
  for (std::size_t i = 0; i < room.pixels.size(); ++i) room.pixels[i] = i % 3 == 0 ? 0.9f : 0.2f;
  const VirtualLights lights = known_lights();
  const auto dots = light_dots(lights, along_z(), kSize, kSize, all_seen);
  const LightPicture picture(room, lights, dots);
  plot::RasterCanvas canvas(picture.width(), picture.height(), {255, 255, 255});
  picture.draw(canvas);
  const auto at = [&](int x, int y) { return canvas.pixels().colours[y * kSize + x]; };
  EXPECT_EQ(at(50, 50), picture.colour(dots[0]));
  const plot::Colour weak = picture.colour(dots[1]);  // its dot covers most of this pixel
  EXPECT_NEAR(at(25, 75).r, weak.r, 12);
  EXPECT_NEAR(at(25, 75).g, weak.g, 12);
  EXPECT_NEAR(at(25, 75).b, weak.b, 12);
  EXPECT_FALSE(picture.colour(dots[0]) == picture.colour(dots[1]));
  const plot::Colour ground = at(75, 25);  // the light turned away lies here
  EXPECT_TRUE(ground.r == ground.g && ground.g == ground.b && ground.r < 140);
  EXPECT_EQ(at(0, 0), ground);
  // One set: the colour is the bounce.
  VirtualLights one = lights;
  one.first = {0, 5};
  const LightPicture bounces(room, one, light_dots(one, along_z(), kSize, kSize, all_seen));
  EXPECT_EQ(bounces.colour({{}, 0, 1, 1}), bounces.colour({{}, 7, 1, 1}));
  EXPECT_FALSE(bounces.colour({{}, 0, 1, 1}) == bounces.colour({{}, 0, 2, 1}));
  EXPECT_EQ(bounces.colour({{}, 0, 6, 1}), bounces.colour({{}, 0, 60, 1}));
}

TEST(VirtualLightList, OneLineALight) {
  const VirtualLights lights = known_lights();
  const std::string csv = virtual_lights_csv(lights);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 6);
  EXPECT_NE(csv.find("\n1,0,2,0,0,4,0,0,-1,4,4,4\n"), std::string::npos) << csv;
  const auto json = nlohmann::json::parse(virtual_lights_json(lights));
  ASSERT_EQ(json.size(), 5u);
  EXPECT_EQ(json[0].at("position"), nlohmann::json({-1, -1, 2}));
  EXPECT_EQ(json[4].at("set"), 1);
  EXPECT_TRUE(nlohmann::json::parse(virtual_lights_json({})).empty());
}

}  // namespace
}  // namespace capcon
