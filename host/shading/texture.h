#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace capcon {

/// What a texture is beyond the unit square: pbrt's "repeat", "black", "clamp".
enum class Wrap : std::uint8_t { repeat, black, clamp };

/// A texture as plain values: an image on uv, times a factor; or, without an image, a constant.
struct Texture {
  int image = -1;  ///< index into Scene::images, -1: `average` everywhere
  Wrap wrap = Wrap::repeat;
  glm::dvec2 scale{1};  ///< s = scale u + offset
  glm::dvec2 offset{0};
  glm::dvec3 factor{1};   ///< what every texel is multiplied by
  bool invert = false;    ///< texel -> 1 - texel, before the factor
  bool encode = false;    ///< the file's numbers were linear and were decoded from sRGB: undo that
  glm::dvec3 average{1};  ///< mean over the image (of the unit square), factor included
};

/// A texture entity as values. What cannot be said by them is replaced by a constant, and `approximations`
/// gets a phrase that says so ("its checkerboard is its mean colour").
/// Read are constant, imagemap, scale (with at most one image in it), mix and checkerboard (as means).
/// `missing` is the colour of an image that was not found (the reader has said so).
Texture read_texture(const Scene& scene, const Entity& entity, const glm::dvec3& missing,
                     std::vector<std::string>& approximations);

/// The texture of that name with values of that kind ("float" or "spectrum"), else of any kind; nullptr if
/// there is none. Of several the last.
const Entity* find_texture(const Scene& scene, const std::string& name, const std::string& values);

/// The value of one texel, as stored and after encode and invert, without the factor.
glm::dvec3 texel(const Texture& texture, const Image& image, int x, int y);

/// The colour at (u, v): bilinear between texel centres, v = 0 at the image's lower edge as in pbrt-v3 and
/// v4.
glm::dvec3 lookup(const Texture& texture, const std::vector<SceneImage>& images, const glm::dvec2& uv);

}  // namespace capcon
