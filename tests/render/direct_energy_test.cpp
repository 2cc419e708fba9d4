// Direct lighting on the device against what energy and probability say, whatever the reference does.
#include "render/lit_scenes.h"

namespace capcon {
namespace {

using namespace testing;

// A white surface within light of radiance 1 has radiance 1, whatever makes that light.
TEST(DirectEnergy, AWhiteFurnaceIsWhite) {
  const std::string sky = "\"infinite\" \"rgb L\" [.25 .25 .25] ";
  const std::string furnaces[] = {
      "LightSource " + sky + "LightSource " + sky + "\"string mapname\" \"white\" LightSource " + sky +
          "\"string filename\" \"white square\" LightSource " + sky + "\"string mapname\" \"white\" ",
      lamp("ReverseOrientation Translate .1 .2 .3 Shape \"sphere\" \"float radius\" 3")};
  Image white(8, 4, 3), square(6, 6, 3);
  for (Image* image : {&white, &square}) std::fill(image->pixels.begin(), image->pixels.end(), 1.0f);
  for (const std::string& furnace : furnaces) {
    Scene scene = test::look_at_origin(matte(1) + "Shape \"disk\" \"float radius\" 1 " + furnace, 8);
    put_images(scene, {{"white", white}, {"white square", square}});
    Renderer renderer(scene, lavapipe());
    for (const Strategy s : {Strategy::power, Strategy::lights, Strategy::bsdf}) {
      const test::Estimate e = test::estimate(renderer.render(lit_job(1024, s)).image);
      EXPECT_NEAR(e.mean, 1, 4 * e.error + 3e-6) << furnace << int(s);
      EXPECT_LT(e.error, 0.003) << furnace;  // or the test would say nothing
    }
  }
}

TEST(DirectEnergy, StrategiesAgreeWithinTheirErrors) {
  const std::string
      coated = "\"rgb Kd\" [.5 .5 .5] \"rgb Ks\" [.5 .5 .5] \"rgb reflectance\" [.5 .5 .5] ",
      lights =
          lamp("Translate -1 .5 1.6 Shape \"sphere\" \"float radius\" .4") +
          lamp("Shape \"trianglemesh\" \"point3 P\" [-1 -1 1 -1 1 1 1 1 2] \"integer indices\" [0 1 2]") +
          "LightSource \"infinite\" \"string mapname\" \"map\"\n";
  Scene scene = look_at_patches(
      patches({"Material \"conductor\" \"float roughness\" .1 ",
               "Material \"plastic\" \"float roughness\" .1 " + coated,
               "Material \"substrate\" \"float uroughness\" .1 \"float vroughness\" .1 " + coated,
               "Material \"coateddiffuse\" \"float roughness\" .1 " + coated},
              2) +
          lights,
      8, 6, 12);
  put_images(scene, {{"map", random_image(16, 9, 4, 60)}});
  Renderer renderer(scene, lavapipe());
  constexpr int kSeeds = 12;
  std::vector<test::Estimate> all[3];  // of each pixel, by strategy
  for (const Strategy s : {Strategy::power, Strategy::lights, Strategy::bsdf}) {
    std::vector<double> sums(48), squares(48);
    DirectLightingJob job = lit_job(512, s);
    for (job.seed = 1; job.seed <= kSeeds; ++job.seed) {
      const Image image = renderer.render(job).image;
      for (int i = 0; i < 48; ++i)
        sums[i] += image.pixels[3 * i], squares[i] += std::pow(image.pixels[3 * i], 2);
    }
    for (int i = 0; i < 48; ++i) {
      const double mean = sums[i] / kSeeds;
      all[s == Strategy::power ? 0 : int(s) - 1].push_back(
          {mean, std::sqrt(std::max(0.0, squares[i] / kSeeds - mean * mean) / (kSeeds - 1))});
    }
  }
  double chi2 = 0, exact = 0;
  for (int k : {1, 2}) {
    for (int i = 0; i < 48; ++i) {
      const test::Estimate &a = all[0][i], &b = all[k][i];
      chi2 += std::pow(a.mean - b.mean, 2) / (a.error * a.error + b.error * b.error);
      exact += std::hypot(a.error, b.error) / a.mean / 96;
    }
  }
  // Errors from 12 seeds: chi^2 of a pixel has a mean near 11/9 and a deviation near 2.
  EXPECT_LT(chi2 / 96, 11.0 / 9 + 4 * 2.1 / std::sqrt(96.0));
  EXPECT_LT(exact, 0.02);  // or the test would say nothing
}

}  // namespace
}  // namespace capcon
