#pragma once

#include "reference/global.h"
#include "render/lit_scenes.h"

namespace capcon::testing {

/// Three walls and what stands in their corner: diffuse, glossy and rough surfaces, with shading normals and
/// texture, below a disk light.
inline Scene furnished_corner(const std::string& lights = test::kCornerLamp, int width = 32,
                              int height = 24) {
  const std::string walls = "Texture \"wall\" \"spectrum\" \"imagemap\" \"string filename\" \"wall.png\" " +
                            within("Material \"diffuse\" \"texture reflectance\" \"wall\" " + test::kCorner);
  const std::string things = within(
                                 "Material \"conductor\" \"float roughness\" .3 Translate -.5 .4 .35 Shape "
                                 "\"sphere\" \"float radius\" "
                                 ".35") +
                             within(
                                 "Material \"plastic\" \"rgb Kd\" [.2 .5 .3] \"rgb Ks\" [.4 .3 .5] \"float "
                                 "roughness\" .2 Translate .1 .1 "
                                 "0 Shape \"trianglemesh\" \"point3 P\" [-.3 -.3 .02 .3 -.3 .02 0 .3 .02 0 0 "
                                 ".5] \"integer indices\" [0 1 3 "
                                 "1 2 3 2 0 3] \"normal N\" [-.3 -.3 .2 .3 -.3 .2 0 .3 .2 0 0 1] ");
  Scene scene = test::parse(
      "LookAt .95 -.95 1.1  -.4 .4 .35  0 0 1 Camera \"perspective\" \"float fov\" 42 WorldBegin " + walls +
          things + lights,
      {true, true, true});
  scene.film = {width, height, ""};
  put_images(scene, {{"wall.png", random_image(5, 4, 9)}, {"map", random_image(24, 12, 1, 50)}});
  return scene;
}

inline GlobalIlluminationJob room_job() {
  GlobalIlluminationJob job;
  job.direct = lit_job(2);
  job.sampler = "sobol-owen";
  job.paths = 16;
  job.sets = 2;
  job.gather = 2;
  job.limit = 3;
  return job;
}

/// The device's image is the reference's with the device's own VPLs, but for `grazing` pixels.
inline void expect_agreement(const std::string& what, Renderer& renderer, const Reference& reference,
                             const GlobalIlluminationJob& job, double tolerance, int grazing) {
  const VirtualLights lights = renderer.virtual_lights(job);
  const Image device = renderer.render(job).image, oracle = reference.render(job, lights).image;
  const Difference d = difference(device, oracle, tolerance);
  EXPECT_LE(d.beyond, grazing) << what << ": worst " << d.worst << " at " << d.worst_pixel % oracle.width
                               << ", " << d.worst_pixel / oracle.width;
  EXPECT_LE(d.median, 1e-5) << what;
  EXPECT_GT(d.lit, oracle.width * oracle.height / 2) << what << " shows little";
  if (std::getenv("CAPCON_SHOW"))
    std::printf("%-40s beyond %d, worst %.2e, median %.2e, mean %.4f, VPLs %zu\n", what.c_str(), d.beyond,
                d.worst, d.median, d.mean, lights.lights.size());
}

}  // namespace capcon::testing
