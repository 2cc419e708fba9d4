#include <fmt/format.h>

#include <cstring>
#include <limits>

#include "stability/cases.h"
#include "stability/scenes.h"

namespace capcon::stability {
namespace {

const std::string kEdges = "a ray that passes an edge within rounding may go either way";

ImageCase case_of(const std::string& name, const std::string& what, const std::string& scene, const Job& job,
                  const ImageBound& bound) {
  return {.group = "integrands", .name = name, .what = what, .scene = scene, .job = job, .bound = bound};
}

void add_occlusion(std::vector<ImageCase>& cases) {
  const std::string scene = room_camera() + world(room());
  const auto add = [&](const std::string& name, const std::string& what, double radius, double share,
                       const std::string& reason) {
    cases.push_back(case_of("radius-" + name, what, scene, occlusion(radius), {1e-4, share, 1e-3, reason}));
  };
  add("tiny", "occlusion radius 1e-9, below the spacing of floats", 1e-9, 0.005,
      "nothing is so near: every ray is open but those that start in an edge");
  add("ulp", "occlusion radius 2.4e-7, the spacing of floats", 2.4e-7, 0.005, "as above");
  add("large", "occlusion radius 1e30, larger than the scene", 1e30, 0.002, kEdges);
  add("infinite", "infinite occlusion radius", std::numeric_limits<double>::infinity(), 0.002, kEdges);
}

std::string sphere(double radius, double x, double y, double z) {
  return fmt::format("Translate {:.17g} {:.17g} {:.17g}\nShape \"sphere\" \"float radius\" {:.17g}\n", x, y,
                     z, radius);
}

std::string disk(double radius, double z) {
  return fmt::format("Translate .2 .1 {}\nScale 1 1 -1\nShape \"disk\" \"float radius\" {:.17g}\n", z,
                     radius);
}

void add_lights(std::vector<ImageCase>& cases) {
  const auto add = [&](const std::string& name, const std::string& what, const std::string& lights,
                       const ImageBound& bound, const std::string& material = matte(0.5)) {
    cases.push_back(case_of(name, what, stage_camera() + world(stage(material) + lights), direct(), bound));
  };
  const ImageBound usual = {1e-4, 0.002, 3e-4, kEdges};
  const std::string coat = "Material \"conductor\" \"float roughness\" .05\n";
  add("disk-light-1e-6", "a disk light of radius 1e-6", lamp(disk(1e-6, 2.2), 1e12), usual);
  add("sphere-light-1e-6", "a sphere light of radius 1e-6 on a glossy floor",
      lamp(sphere(1e-6, .2, .1, 2.2), 1e12), {1e-4, 0.002, 3e-4, kEdges}, coat);
  add("sphere-light-1e-15", "a sphere light of radius 1e-15: densities of 1e30, weights of BSDF samples 0",
      lamp(sphere(1e-15, .2, .1, 2.2), 1e30), usual, coat);
  add("sphere-light-1e6", "everything within a sphere light of radius 1e6",
      within("ReverseOrientation\n" + lamp(sphere(1e6, 0, 0, 0))), usual);
  add("disk-light-1e6", "a disk light of radius 1e6 above the floor", lamp(disk(1e6, 30)), usual);
  add("light-touches", "a sphere light that touches the floor", lamp(sphere(.5, .9, .2, .5)),
      {1e-3, 0.002, 3e-4, "at the touching point distances are as small as the rounding of the position"});
  add("light-encloses", "the sphere within a sphere light of twice its size", lamp(sphere(.7, -.5, .3, .45)),
      {1e-3, 0.002, 3e-4, "where the light cuts the floor distances are as small as rounding"});
  add("radiance-1e-20", "radiance 1e-20", lamp(disk(.5, 2.2), 1e-20), usual);
  add("radiance-1e30", "radiance 1e30", lamp(disk(.5, 2.2), 1e30), usual);
  add("radiances-together", "lights of radiance 1e-20 and 1e30",
      lamp(disk(.5, 2.2), 1e30) + lamp(sphere(.1, .9, .2, .9), 1e-20), usual);
}

Image map_with(float everywhere, float peak) {
  Image image(32, 32, 3);
  for (float& v : image.pixels) v = everywhere;
  for (int c = 0; c < 3; ++c) image.at(21, 13, c) = peak;
  return image;
}

void add_environments(std::vector<ImageCase>& cases) {
  const auto add = [&](const std::string& name, const std::string& what, const Image& image,
                       const std::string& more) {
    ImageCase c = case_of(
        name, what,
        stage_camera() +
            world("LightSource \"infinite\" \"string filename\" \"" + name + ".exr\"\n" + more + stage()),
        direct(), {2e-4, 0.002, 3e-4, kEdges + "; the map's cells are told apart by floats"});
    c.images[name + ".exr"] = image;
    cases.push_back(std::move(c));
  };
  add("environment-1e8", "an environment with one texel of 1e8 among ones", map_with(1, 1e8f), "");
  add("environment-black-but-one", "an environment that is black but for one texel", map_with(0, 1), "");
  add("environment-black", "an all-black environment beside a lamp", map_with(0, 0), lamp(disk(.5, 2.2)));
}

std::string merl() {
  constexpr int kSizes[3] = {16, 16, 32};
  std::string bytes(12, '\0');
  std::memcpy(bytes.data(), kSizes, 12);
  for (int i = 0; i < 3 * kSizes[0] * kSizes[1] * kSizes[2]; ++i) {
    const int kind = i * 7919 % 11;  // zeros, negatives (holes), ordinary and huge values side by side
    const double value = kind == 0 ? 0 : kind == 1 ? -1 : kind == 2 ? -1e5 : kind == 3 ? 1e6 : 300.0 * kind;
    bytes.append(reinterpret_cast<const char*>(&value), 8);
  }
  return bytes;
}

void add_materials(std::vector<ImageCase>& cases) {
  const std::string lights = lamp(disk(.5, 2.2)) + lamp(sphere(.15, -1.2, -.6, .6), 10);
  const auto add = [&](const std::string& name, const std::string& what, const std::string& material,
                       const ImageBound& bound) {
    cases.push_back(case_of(name, what, stage_camera() + world(stage(material) + lights), direct(), bound));
  };
  for (const char* roughness : {"0", "1e-4", "1"}) {
    add(fmt::format("conductor-roughness-{}", roughness),
        fmt::format("a conductor of roughness {}", roughness),
        fmt::format("Material \"conductor\" \"float roughness\" {}\n", roughness),
        {1e-3, 0.002, 3e-4, "a lobe as narrow as alpha magnifies the rounding of directions by 1 / alpha"});
    add(fmt::format("plastic-roughness-{}", roughness), fmt::format("plastic of roughness {}", roughness),
        fmt::format("Material \"coateddiffuse\" \"float roughness\" {}\n", roughness),
        {1e-3, 0.002, 3e-4, "as above"});
  }
  cases.push_back(case_of("direct-grazing", "a glossy floor seen at 1e-4 radians",
                          camera({0, -4, 4e-4}, {0, 0, 0}, 1) +
                              world(stage("Material \"conductor\" \"float roughness\" .1\n") + lights),
                          direct(),
                          {1e-3, 0.005, 1e-3, "the hit moves by rounding / sin(angle) along the floor"}));
  ImageCase measured = case_of(
      "measured-holes", "a measured table with zeros, negatives, holes and values of 1e6",
      stage_camera() + world(stage("Material \"measured\" \"string filename\" \"holes.binary\"\n") + lights),
      direct(), {1e-3, 0.002, 3e-4, "cells of the table are told apart by floats"});
  measured.files["holes.binary"] = merl();
  cases.push_back(std::move(measured));
}

}  // namespace

std::vector<ImageCase> integrand_cases() {
  std::vector<ImageCase> cases;
  add_occlusion(cases);
  add_lights(cases);
  add_environments(cases);
  add_materials(cases);
  return cases;
}

}  // namespace capcon::stability
