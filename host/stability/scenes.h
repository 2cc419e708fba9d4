#pragma once

#include <glm/vec3.hpp>
#include <string>

#include "stability/image_case.h"

namespace capcon::stability {

// Scenes are pbrt text, so that a case can be looked at and rendered again by hand.

/// Where a scene and its camera lie: p -> scale p + offset.
struct Place {
  double scale = 1;
  glm::dvec3 offset{0};
};

/// Film of 64 x 48 pixels and a camera; `up` may not be along the view. Lengths are the scene's own, before
/// `place`.
std::string camera(const glm::dvec3& eye, const glm::dvec3& at, double fov, const Place& place = {},
                   const glm::dvec3& up = {0, 0, 1}, int width = 64, int height = 48);
/// What follows "WorldBegin", under the place's transform.
std::string world(const std::string& text, const Place& place = {});
/// Between AttributeBegin and AttributeEnd.
std::string within(const std::string& text);
std::string matte(double albedo);
/// A diffuse area light: `shape` transforms and makes the shape.
std::string lamp(const std::string& shape, double radiance = 1);
/// A parallelogram with corner p; it faces along cross(u, v).
std::string parallelogram(const glm::dvec3& p, const glm::dvec3& u, const glm::dvec3& v);
/// A mesh of loose triangles.
std::string triangles(const std::vector<glm::dvec3>& points);
/// Six outward sides.
std::string box(const glm::dvec3& low, const glm::dvec3& high);

/// The room that most cases start from, about 4 wide: floor and two walls, a turned box, a sphere, a thin
/// plate, all matte, and a disk light.
std::string room();
/// The camera that sees it.
std::string room_camera(const Place& place = {});

/// What has no light of its own: a floor from (-50, -50) to (50, 50) with a sphere and a plate that throw
/// shadows, to be lit.
std::string stage(const std::string& floor_material = matte(0.5));
std::string stage_camera();

}  // namespace capcon::stability
