// Which points direct lighting takes: splits, parts, filters and samplers, on the device as in the reference.
#include "render/lit_scenes.h"

namespace capcon {
namespace {

using namespace testing;

struct Split {
  std::uint32_t image, integrator;
};

Scene split_scene() {
  return look_at_patches(kShades + patches({matte(0.6), "Material \"plastic\" \"float roughness\" .1 "}, 2) +
                             lamp("ReverseOrientation Translate .2 .1 2 Shape \"disk\" \"float radius\" .8"),
                         16, 12);
}

// Image samples that are jittered move edges through more pixels than rounding alone.
TEST(DirectPoints, AgreeWithTheReferenceForEverySamplerAndSplit) {
  const Scene scene = split_scene();
  Renderer renderer(scene, lavapipe());
  const Reference reference(scene);
  int k = 0;
  for (const std::string& sampler : sampler_names()) {
    const PixelFilter filter = ++k % 2 ? PixelFilter::gaussian : PixelFilter::box;
    for (const Split split : {Split{4, 4}, {16, 1}, {3, 5}}) {
      for (const bool partition : {true, false}) {
        if (!partition && split.image == 16) continue;
        if (sampler == "capcon-domain" && split.image == 3)
          continue;  // its sets of unusual sizes are slow to make
        DirectLightingJob job = lit_job();
        job.sampler = sampler;
        job.image_samples = split.image;
        job.integrator_samples = split.integrator;
        job.partition = partition;
        job.position = split.image == 3 ? PixelPosition::centre : PixelPosition::jittered;
        job.filter = filter;
        job.seed += split.image;
        expect_agreement(sampler + " " + std::to_string(split.image) + "x" +
                             std::to_string(split.integrator) + (partition ? " parts" : " sets"),
                         renderer, reference, job, 1e-4, 3);
      }
    }
  }
}

// A sampler whose points depend on the domain: every light's own, and that of a sphere by where it is seen
// from.
TEST(DirectPoints, LieInTheDomainOfEachLight) {
  Scene scene = look_at_patches(
      ground() + lamp("ReverseOrientation Translate .2 .1 2 Shape \"disk\" \"float radius\" .8") +
      lamp("Translate .3 .3 .2 Shape \"sphere\" \"float radius\" .9", "\"bool twosided\" true ") +
      lamp("Shape \"trianglemesh\" \"point3 P\" [-1 -.5 1.6 -.8 1 1.7 .9 1.2 1.2 .7 -.3 1.1] \"integer "
           "indices\" [0 1 2 0 2 3] ") +
      "LightSource \"infinite\" \"rgb L\" [.3 .4 .6] LightSource \"infinite\" \"string mapname\" \"map\"\n");
  put_images(scene, {{"map", random_image(24, 12, 1, 50)}});
  DirectLightingJob job = lit_job(16);
  job.sampler = "capcon-domain";
  expect_agreement("domains", scene, job, 1e-4, 2);
}

TEST(DirectPoints, SetsAndPartsDiffer) {
  const Scene scene = split_scene();
  Renderer renderer(scene, lavapipe());
  DirectLightingJob job = lit_job(4);
  job.image_samples = 4;
  const auto parts = renderer.render(job).image.pixels;
  job.partition = false;
  EXPECT_NE(parts, renderer.render(job).image.pixels);
}

}  // namespace
}  // namespace capcon
