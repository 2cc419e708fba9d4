#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "base/hash.h"
#include "reference/lighting.h"
#include "render/renderer.h"
#include "scene/scene_text.h"

namespace capcon::testing {

using test::lamp;
using test::matte;
using test::within;

inline RendererOptions lavapipe(const char* fetch = "auto", const char* instancing = "auto") {
  return {.device = "lavapipe", .fetch = fetch, .instancing = instancing, .shading = true, .validate = true};
}

/// A grid of squares of side 1 about the origin, facing +z, one a material; with uvs beyond the unit square
/// and normals that lean outwards, as a curved surface has them. `shape`: what goes before each square's
/// shape.
inline std::string patches(const std::vector<std::string>& materials, int columns,
                           const std::string& shape = "") {
  std::string text;
  const int rows = (static_cast<int>(materials.size()) + columns - 1) / columns;
  for (int i = 0; i < static_cast<int>(materials.size()); ++i) {
    const double x = i % columns - columns / 2.0, y = i / columns - rows / 2.0;
    text += within(
        materials[i] + shape + "Translate " + std::to_string(x) + " " + std::to_string(y) +
        " 0 Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 1 1 0 0 1 0] \"integer indices\" [0 1 2 0 2 3] "
        "\"normal N\" [-.3 -.2 1 .3 -.2 1 .2 .3 2 -.2 .2 1] \"point2 uv\" [-.7 -.4 1.6 -.3 1.4 1.7 -.6 "
        "1.5] ");
  }
  return text;
}

/// Things that throw shadows onto the patches.
inline const std::string kShades =
    within(matte(0.3) + "Translate 1.1 .3 .5 Shape \"sphere\" \"float radius\" .3") +
    within(
        matte(0.3) +
        "Shape \"trianglemesh\" \"point3 P\" [-1 -.6 .4 -.4 .2 .9 -1.2 .5 .6] \"integer indices\" [0 1 2] ");

/// The patches obliquely from above.
inline Scene look_at_patches(const std::string& text, int width = 32, int height = 24, double fov = 16) {
  Scene scene = test::parse("LookAt .4 -4.3 4.1  0.03 -.1 0.02  0 0 1 Camera \"perspective\" \"float fov\" " +
                                std::to_string(fov) + " WorldBegin " + text,
                            {true, true, true});
  scene.film = {width, height, ""};
  return scene;
}

/// Gives every texture and environment that names an image file the image of that name.
inline void put_images(Scene& scene, const std::vector<SceneImage>& images) {
  scene.images = images;
  for (auto* entities : {&scene.lights, &scene.textures}) {
    for (Entity& entity : *entities) {
      for (const char* name : {"mapname", "filename"}) {
        for (std::size_t i = 0; i < images.size(); ++i) {
          if (entity.parameters.string(name, "") == images[i].file) entity.image = static_cast<int>(i);
        }
      }
    }
  }
}

/// An image of random colours, one texel of which is `peak` times as bright.
inline Image random_image(int width, int height, std::uint64_t seed, float peak = 1) {
  Image image(width, height, 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<float>(0.05 + 0.9 * uniform64(seed, static_cast<int>(i), 0));
  for (int c = 0; c < 3; ++c) image.at(width / 3, height / 4, c) *= peak;
  return image;
}

/// Two diffuse patches, a glossy metal one and a plastic one, with shades above.
inline std::string ground() {
  return kShades +
         patches({"Material \"diffuse\" \"rgb reflectance\" [.7 .5 .3]\n",
                  "Material \"metal\" \"float roughness\" .2 ",
                  "Material \"plastic\" \"rgb Kd\" [.2 .4 .3] \"rgb Ks\" [.4 .3 .5] \"float roughness\" .05 ",
                  matte(0.6)},
                 2);
}

inline DirectLightingJob lit_job(std::uint32_t samples = 4, Strategy strategy = Strategy::power) {
  DirectLightingJob job;
  job.sampler = "sobol-owen";
  job.integrator_samples = samples;
  job.strategy = strategy;
  job.seed = 3;
  return job;
}

/// How an image differs from another, pixel by pixel, relative to the other's brightest channel.
struct Difference {
  int beyond = 0;  ///< pixels that differ by more than the tolerance
  double median = 0;
  double worst = 0;
  int worst_pixel = 0;
  double mean = 0;  ///< of the other image
  int lit = 0;      ///< pixels of the other that are not black
};

inline Difference difference(const Image& image, const Image& other, double tolerance) {
  Difference d;
  std::vector<double> all;
  const int count = other.width * other.height;
  for (int i = 0; i < count; ++i) {
    double most = 0, error = 0;
    for (int c = 0; c < 3; ++c) {
      const double a = image.pixels[3 * i + c], b = other.pixels[3 * i + c];
      most = std::max(most, b);
      error = std::isfinite(a) ? std::max(error, std::abs(a - b)) : 1e30;
    }
    d.mean += most / count;
    d.lit += most > 0;
    const double relative = error / (most + 1e-6);
    all.push_back(relative);
    d.beyond += relative > tolerance;
    if (relative > d.worst) d.worst = relative, d.worst_pixel = i;
  }
  std::nth_element(all.begin(), all.begin() + count / 2, all.end());
  d.median = all[count / 2];
  return d;
}

/// The device's image is the reference's: same points, so that nothing but rounding differs, and rays that
/// graze an edge: `grazing` pixels.
inline void expect_agreement(const std::string& what, Renderer& renderer, const Reference& reference,
                             const DirectLightingJob& job, double tolerance = 1e-4, int grazing = 1) {
  const Image device = renderer.render(job).image, oracle = reference.render(job).image;
  const Difference d = difference(device, oracle, tolerance);
  EXPECT_LE(d.beyond, grazing) << what << ": worst " << d.worst << " at " << d.worst_pixel % oracle.width
                               << ", " << d.worst_pixel / oracle.width;
  EXPECT_LE(d.median, 1e-5) << what;
  EXPECT_GT(d.mean, 1e-3) << what << " shows nothing";
  EXPECT_GT(d.lit, oracle.width * oracle.height / 8) << what << " shows little";
  if (std::getenv("CAPCON_SHOW"))
    std::printf("%-40s beyond %d, worst %.2e, median %.2e, mean %.4f, lit %d\n", what.c_str(), d.beyond,
                d.worst, d.median, d.mean, d.lit);
}

/// The same of a scene of its own.
inline void expect_agreement(const std::string& what, const Scene& scene, const DirectLightingJob& job,
                             double tolerance = 1e-4, int grazing = 1,
                             const RendererOptions& options = lavapipe()) {
  Renderer renderer(scene, options);
  expect_agreement(what, renderer, Reference(scene), job, tolerance, grazing);
}

}  // namespace capcon::testing
