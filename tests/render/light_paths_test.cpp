// Light paths on the device: the reference's, hit for hit, but for those that graze an edge; and what energy
// says of them.
#include "render/lit_rooms.h"
#include "shading/light.h"

namespace capcon {
namespace {

using namespace testing;

/// How many of the VPLs of two renderers are the same, of all.
struct Same {
  int same = 0, all = 0;
};

Same same_lights(const VirtualLights& a, const VirtualLights& b) {
  Same result;
  std::map<std::array<std::uint32_t, 3>, const VirtualLight*> known;
  for (std::uint32_t set = 0; set < b.sets(); ++set) {
    for (std::uint32_t k = b.first[set]; k < b.first[set + 1]; ++k)
      known[{set, b.lights[k].path, b.lights[k].bounce}] = &b.lights[k];
  }
  for (std::uint32_t set = 0; set < a.sets(); ++set) {
    for (std::uint32_t k = a.first[set]; k < a.first[set + 1]; ++k) {
      const VirtualLight& x = a.lights[k];
      const auto found = known.find({set, x.path, x.bounce});
      ++result.all;
      if (found == known.end()) continue;
      const VirtualLight& y = *found->second;
      result.same +=
          glm::distance(x.position, y.position) < 2e-4 && glm::distance(x.normal, y.normal) < 2e-4 &&
          glm::distance(x.shading_normal, y.shading_normal) < 2e-3 &&
          glm::distance(x.arriving, y.arriving) < 2e-4 && x.material == y.material &&
          glm::distance(x.flux, y.flux) < 2e-3 * glm::length(y.flux) && glm::distance(x.uv, y.uv) < 1e-3;
    }
  }
  result.all = std::max(result.all, static_cast<int>(b.lights.size()));
  return result;
}

/// Rounding grows with every bounce off a curved or glossy surface, and paths that graze an edge part.
void expect_same_paths(const std::string& what, const Scene& scene, GlobalIlluminationJob job) {
  Renderer renderer(scene, lavapipe());
  const VirtualLights device = renderer.virtual_lights(job);
  const Same same = same_lights(device, Reference(scene).trace_virtual_lights(job));
  EXPECT_GE(same.same, 0.97 * same.all) << what;
  EXPECT_GT(same.all, 100) << what << " says little";
  if (std::getenv("CAPCON_SHOW")) std::printf("%-30s %d of %d\n", what.c_str(), same.same, same.all);
}

TEST(LightPaths, StartAsTheReferenceSaysOnEveryKindOfLight) {
  const std::string turned = "ReverseOrientation ";
  const std::pair<const char*, std::string> lights[] = {
      {"disk", test::kCornerLamp},
      {"ring", lamp("ReverseOrientation Translate .2 0 1.5 Shape \"disk\" \"float radius\" .5 \"float "
                    "innerradius\" .3")},
      {"two-sided disk",
       lamp("Translate .2 0 1.5 Shape \"disk\" \"float radius\" .5", "\"bool twosided\" true ")},
      {"sphere", lamp("Translate .2 0 1.4 Shape \"sphere\" \"float radius\" .3")},
      {"sphere around", lamp(turned + "Shape \"sphere\" \"float radius\" 3")},
      {"rectangle",
       lamp("Shape \"trianglemesh\" \"point3 P\" [-.3 -.3 1.6 -.3 .4 1.7 .5 .4 1.7 .5 -.3 1.6] \"integer "
            "indices\" [0 1 2 0 2 3]")},
      {"triangles",
       lamp("Shape \"trianglemesh\" \"point3 P\" [-.8 -.5 1.6 -.6 1 1.7 .7 .8 1.2 .7 -.3 1.1 0 0 1.9] "
            "\"integer indices\" [0 1 4 1 2 4 2 3 4 3 0 4]")},
      {"ellipsoid", lamp("Translate .2 0 1.4 Scale 1 .6 .5 Shape \"sphere\" \"float radius\" .4")},
      {"environment", "LightSource \"infinite\" \"string mapname\" \"map\"\n"},
      {"constant environment", "LightSource \"infinite\" \"rgb L\" [.3 .4 .6]\n"},
      {"distant", "LightSource \"distant\" \"point3 from\" [.6 -.9 1.4] \"point3 to\" [0 0 0]\n"},
      {"point", "LightSource \"point\" \"point3 from\" [.2 -.1 1.2] \"rgb I\" [3 2 1]\n"}};
  GlobalIlluminationJob job = room_job();
  job.paths = 256;
  std::string all;
  for (const auto& [name, text] : lights) {
    job.sampler = "capcon-domain";  // whose points depend on the domain
    expect_same_paths(name, furnished_corner(text), job);
    if (std::string(name) != "sphere around") all += text;
  }
  job.sets = 4;
  expect_same_paths("all lights", furnished_corner(all), job);
}

TEST(LightPaths, TakeTheSamplersPoints) {
  const Scene scene = furnished_corner();
  GlobalIlluminationJob job = room_job();
  job.paths = 64;
  job.sets = 4;
  for (const char* sampler : {"jittered", "sobol-owen", "ccvt", "capcon"}) {
    for (const bool partition : {true, false}) {
      job.sampler = sampler;
      job.partition = partition;
      expect_same_paths(std::string(sampler) + (partition ? " parts" : " sets"), scene, job);
    }
  }
}

// In a closed box of albedo rho what arrives is power / (1 - rho), bounce by bounce power rho^(b - 1).
TEST(LightPaths, HaveTheEnergyOfAGeometricSeriesInAClosedBox) {
  for (const double albedo : {0.5, 0.9}) {
    const Scene scene =
        test::view_of(within(matte(albedo) + "Scale 2 2 2 " + test::kBox) +
                          lamp(matte(albedo) + "Translate .3 .2 .1 Shape \"sphere\" \"float radius\" .3"),
                      {1, 1, 1}, {0, 0, 0}, 60, 4);
    Renderer renderer(scene, lavapipe());
    const double power = M_PI * 4 * M_PI * 0.3 * 0.3;
    GlobalIlluminationJob job = room_job();
    job.sampler = "random";
    job.paths = 4096;
    job.sets = 8;
    std::vector<double> sums;
    std::vector<std::vector<double>> by_bounce(4);
    const VirtualLights lights = renderer.virtual_lights(job);
    for (std::uint32_t set = 0; set < job.sets; ++set) {
      double sum = 0;
      std::vector<double> bounce(4);
      for (std::uint32_t k = lights.first[set]; k < lights.first[set + 1]; ++k) {
        sum += lights.lights[k].flux.x / power;
        if (lights.lights[k].bounce <= 4)
          bounce[lights.lights[k].bounce - 1] += lights.lights[k].flux.x / power;
      }
      sums.push_back(sum);
      for (int b = 0; b < 4; ++b) by_bounce[b].push_back(bounce[b]);
    }
    const test::Estimate all = test::estimate_of(sums);
    EXPECT_NEAR(all.mean, 1 / (1 - albedo), 4 * all.error) << albedo;
    EXPECT_LT(all.error, 0.02 / (1 - albedo));
    for (int b = 0; b < 4; ++b) {
      const test::Estimate e = test::estimate_of(by_bounce[b]);
      EXPECT_NEAR(e.mean, std::pow(albedo, b), 4 * e.error + 1e-6) << albedo << " bounce " << b + 1;
    }
  }
}

}  // namespace
}  // namespace capcon
