// Points on BSDFs and lights, and their densities, as the device's functions alone give them: point by point
// against the reference, and directions against densities by chi-square.
#include <algorithm>
#include <numbers>

#include "gpu/commands.h"
#include "reference/bsdf.h"
#include "reference/chi_square.h"
#include "reference/geometry.h"
#include "reference/light_sampling.h"
#include "render/lit_scenes.h"
#include "render/renderer_state.h"
#include "render/texels.h"
#include "spirv/shading_samples_storage.h"
#include "spirv/shading_samples_texel.h"

namespace capcon {
namespace {

using namespace testing;
using glm::dvec3;

struct Question {
  dvec3 first;
  std::uint32_t index;
  dvec3 second;
  glm::uvec3 bits;  ///< of a point and of a choice
};
struct Answer {
  glm::vec4 a, b;
};
enum Mode : std::uint32_t { kBsdf, kSample, kMeet };

/// Runs tests/shaders/shading_samples.comp on a scene's materials and lights.
std::vector<Answer> ask(RendererState& state, Mode mode, std::uint32_t light_kind,
                        const std::vector<Question>& questions) {
  std::vector<glm::uvec4> texels;
  for (const Question& q : questions) {
    texels.push_back(make_texel(q.first, q.index));
    texels.push_back(make_texel(q.second, 0u));
    texels.emplace_back(q.bits, 0);
  }
  const bool texel = state.kernels.texel_fetch();
  const gpu::Access access = texel ? gpu::Access::texels : gpu::Access::storage;
  std::map<std::uint32_t, gpu::Access> bindings = {{layout::kBindSums, gpu::Access::storage}};
  for (const std::uint32_t b : {layout::kBindMaterials, layout::kBindTextures, layout::kBindLights,
                                layout::kBindEnvironment, layout::kBindQuadrics, layout::kBindRays})
    bindings[b] = access;
  const std::span<const std::uint32_t> spirv =
      texel ? std::span<const std::uint32_t>(k_shading_samples_texel_spirv) : k_shading_samples_storage_spirv;
  gpu::Kernel kernel(state.device, spirv, bindings, state.constants({"", {{layout::kSpecLight, light_kind}}}),
                     8);
  const gpu::Buffer input = gpu::make_buffer<glm::uvec4>(state.device, texels);
  const gpu::Buffer output(state.device, sizeof(Answer) * questions.size(), gpu::Memory::host);
  state.bind_all(kernel);
  kernel.bind(layout::kBindRays, input);
  kernel.bind(layout::kBindSums, output);
  const std::uint32_t push[2] = {mode, static_cast<std::uint32_t>(questions.size())};
  gpu::Commands commands(state.device);
  commands.dispatch(kernel, push, (push[1] + layout::kGroupSize - 1) / layout::kGroupSize, "samples");
  commands.submit_and_wait();
  std::vector<Answer> answers(questions.size());
  output.download(answers.data(), sizeof(Answer) * answers.size());
  return answers;
}

/// Random points with a choice each.
std::vector<Question> points(const dvec3& first, std::uint32_t index, const dvec3& second,
                             int count = 40000) {
  std::vector<Question> all;
  for (int i = 0; i < count; ++i) {
    const auto random = [&](int k) {
      return static_cast<std::uint32_t>(uniform64(21 + index, i, k) * 4294967296.0);
    };
    all.push_back({first, index, second, {random(0), random(1), random(2)}});
  }
  return all;
}
double unit(std::uint32_t bits) {
  return (bits >> 8) / 16777216.0;
}

dvec3 direction(double degrees, double azimuth) {
  const double theta = degrees * std::numbers::pi / 180;
  return {std::sin(theta) * std::cos(azimuth), std::sin(theta) * std::sin(azimuth), std::cos(theta)};
}

/// Half of these differ by no more than a few roundings, and all but a thousandth by less than `most`: near
/// the rims of disks and lobes square roots cancel.
void expect_small(std::vector<double> differences, double most, const std::string& what) {
  const auto place = [&](std::size_t n) { return differences.begin() + static_cast<std::ptrdiff_t>(n); };
  const std::size_t count = differences.size();
  ASSERT_GT(count, 100u) << what;
  std::sort(differences.begin(), differences.end());
  EXPECT_LT(*place(count / 2), 2e-6) << what;
  EXPECT_LT(*place(count - 1 - count / 1000), most) << what;
}

TEST(DeviceSamples, OfBsdfsAreTheReferencesAndAsDenseAsTheySay) {
  const std::string coat =
      "\"rgb Kd\" [.5 .4 .3] \"rgb Ks\" [.3 .4 .5] \"rgb reflectance\" [.5 .4 .3] \"bool remaproughness\" "
      "false ";
  const auto rough = [](const char* r) { return std::string("\"float roughness\" ") + r + " "; };
  const std::string text =
      matte(0.7) + "Shape \"disk\" " + "Material \"conductor\" \"bool remaproughness\" false " +
      rough(".05") + "Shape \"disk\" Material \"conductor\" \"bool remaproughness\" false " + rough("1") +
      "Shape \"disk\" Material \"plastic\" " + coat + rough(".1") + "Shape \"disk\" Material \"substrate\" " +
      coat + "\"float uroughness\" .3 \"float vroughness\" .3 Shape \"disk\" Material \"coateddiffuse\" " +
      coat + rough(".2") + "Shape \"disk\" ";
  const Scene scene = look_at_patches(text);
  Renderer renderer(scene, lavapipe());
  const reference::Bsdfs bsdfs(scene);
  ASSERT_EQ(scene.materials.size(), 6u);
  for (int m = 0; m < 6; ++m) {
    const reference::Bsdf bsdf = bsdfs.at(m, {0, 0});
    for (const double degrees : {20.0, 75.0}) {
      const dvec3 out(glm::vec3(direction(degrees, 0.7)));
      const auto questions = points(out, std::uint32_t(m), dvec3(0));
      const auto answers = ask(renderer.state(), kBsdf, 0, questions);
      std::vector<double> ways, densities, values;
      for (std::size_t i = 0; i < questions.size(); ++i) {
        const auto& [a, b] = answers[i];
        const glm::uvec3 bits = questions[i].bits;
        const auto expected = bsdf.sample(out, {unit(bits.x), unit(bits.y)}, unit(bits.z));
        EXPECT_TRUE(expected.has_value() == (a.z > 0) || std::abs(a.z) < 1e-5);
        if (!expected || !(a.z > 0)) continue;
        ways.push_back(glm::distance(*expected, dvec3(a)));
        // Of the direction that the device has: densities of sharp lobes differ more by where they are taken.
        const dvec3 in = glm::normalize(dvec3(a));
        densities.push_back(std::abs(a.w / bsdf.pdf(in, out) - 1));
        values.push_back(glm::distance(dvec3(b), bsdf.evaluate(in, out)) /
                         glm::length(bsdf.evaluate(in, out)));
      }
      expect_small(ways, 3e-5, std::to_string(m) + " directions");
      expect_small(densities, 1e-4, std::to_string(m) + " densities");
      expect_small(values, 1e-4, std::to_string(m) + " values");
      std::size_t next = 0;
      const test::ChiSquare c = test::chi_square(
          dvec3(-out.x, -out.y, out.z),
          [&](const glm::dvec2&, double) -> std::optional<dvec3> {
            const glm::vec4 a = answers.at(next++).a;
            return a.z > 0 ? std::optional(glm::normalize(dvec3(a))) : std::nullopt;
          },
          [&](const dvec3& in) { return bsdf.pdf(in, out); });
      EXPECT_LT(c.sigmas, 4) << m << " from " << degrees;
    }
  }
}

/// Lights as the reference has them.
struct Lit {
  Scene scene;
  reference::Geometry geometry{scene};
  reference::LightSampling lights{scene, geometry.primitives};

  /// The density of a light's samples in a direction, by a ray that meets nothing else.
  reference::LightMet met(int light, const dvec3& from, const dvec3& way) const {
    if (lights.lights().values[light].kind == LightKind::environment)
      return lights.environment(light, {0, 0, 1}, way);
    const reference::Ray ray(from, way);
    double nearest = -1;
    std::uint32_t met = 0;
    for (std::uint32_t p = 0; p < geometry.primitives.size(); ++p) {
      const double t = lights.of_primitive(p) == light ? geometry.primitives.intersect(p, ray, 1e30) : -1;
      if (t > 0 && (nearest < 0 || t < nearest)) nearest = t, met = p;
    }
    return nearest < 0 ? reference::LightMet{} : lights.meet(light, met, ray, nearest);
  }
};

/// Lights of all kinds about the origin.
Scene all_lights() {
  const std::string two = "\"bool twosided\" true ", points_of = "Shape \"trianglemesh\" \"point3 P\" ";
  const std::string text =
      lamp("Translate 0 2 .5 Rotate 70 1 .3 0 Scale 2 1 1 Shape \"disk\" \"float innerradius\" .6 ", two) +
      lamp("Translate 30 0 3 Shape \"sphere\" \"float radius\" 4 ") +
      lamp("Translate -1.01 0 0 Shape \"sphere\" ") +
      lamp(points_of + "[-1 -2 0 1 -2 0 1 -2 1.5 -1 -2 1.5] \"integer indices\" [0 1 2 0 2 3] ", two) +
      lamp(
          points_of + "[0 0 -1 2 0 -1 2 1 -1 0 1 -2 -1 -1 -1] \"integer indices\" [0 1 2 0 1 1 0 2 3 0 3 4] ",
          two) +
      lamp("ReverseOrientation Scale 50 50 50 Translate 0 .3 .4 Shape \"sphere\" ") +
      "LightSource \"infinite\" \"rgb L\" [1 1 1] " +
      within(
          "Rotate 50 1 2 3 LightSource \"infinite\" \"string mapname\" \"odd\" "
          "LightSource \"infinite\" \"string filename\" \"square\" ");
  Scene scene = look_at_patches(text);
  put_images(scene, {{"odd", random_image(24, 11, 1, 500)}, {"square", random_image(16, 16, 2, 500)}});
  return scene;
}

const dvec3 kFrom(0.0078125, -0.015625, 0.03125), kUp(0, 0, 1);

TEST(DeviceSamples, OfLightsAreTheReferencesAndAsDenseAsTheySay) {
  const Scene scene = all_lights();
  Renderer renderer(scene, lavapipe());
  RendererState& state = renderer.state();
  const Lit lit{scene};
  ASSERT_EQ(lit.lights.count(), 9);
  const dvec3 from = kFrom, up = kUp;
  for (int j = 0; j < lit.lights.count(); ++j) {
    const auto index = static_cast<std::uint32_t>(j), kind = state.light_list.kinds[j];
    const auto questions = points(from, index, up);
    const auto answers = ask(state, kSample, kind, questions);
    std::vector<double> ways, densities, values, met_densities;
    std::vector<Question> towards;
    dvec3 axis(0);
    for (std::size_t i = 0; i < questions.size(); ++i) {
      const auto& [a, b] = answers[i];
      const auto expected =
          lit.lights.sample(j, from, up, {unit(questions[i].bits.x), unit(questions[i].bits.y)});
      if (!expected) continue;
      axis += expected->direction;
      towards.push_back({from, index, expected->direction, {}});
      ways.push_back(glm::distance(expected->direction, dvec3(a)));
      densities.push_back(std::abs(a.w / expected->pdf - 1));
      const bool far = expected->distance > 1e30;
      values.push_back(glm::distance(dvec3(b), expected->radiance) / glm::length(expected->radiance) +
                       (far ? (b.w < 1e38) : std::abs(b.w / expected->distance - 1)));
    }
    EXPECT_EQ(ways.size(), questions.size()) << j;
    expect_small(ways, 3e-6, std::to_string(j) + " directions");
    expect_small(densities, 1e-4, std::to_string(j) + " densities");
    expect_small(values, 1e-4, std::to_string(j) + " values");
    // Rays towards the points meet the light with that density; of meshes the nearest surface says it.
    if (kind != layout::kLightTriangles) {
      const auto met = ask(state, kMeet, kind, towards);
      for (std::size_t i = 0; i < met.size(); ++i) {
        const reference::LightMet expected = lit.met(j, from, towards[i].second);
        met_densities.push_back(std::abs(met[i].a.w / expected.pdf - 1) + (met[i].a.z > 0 ? 0 : 1));
      }
      expect_small(met_densities, 1e-4, std::to_string(j) + " densities of rays");
    }
    std::size_t next = 0;
    const test::ChiSquare c = test::chi_square(
        glm::normalize(axis),
        [&](const glm::dvec2&, double) -> std::optional<dvec3> {
          return glm::normalize(dvec3(answers.at(next++).a));
        },
        [&](const dvec3& way) { return lit.met(j, from, way).pdf; });
    EXPECT_LT(c.sigmas, 4) << j;
  }
}

// The square's corners, edges and middle, where maps have their seams.
TEST(DeviceSamples, OfLightsAtTheSeamsAreTheReferences) {
  const Scene scene = all_lights();
  Renderer renderer(scene, lavapipe());
  const Lit lit{scene};
  const std::uint32_t seams[] = {0,          0x100,      0x40000000, 0x7fffff00,
                                 0x80000000, 0x80000100, 0xc0000000, 0xffffff00};
  for (int j = 0; j < lit.lights.count(); ++j) {
    std::vector<Question> questions;
    for (const std::uint32_t x : seams)
      for (const std::uint32_t y : seams)
        questions.push_back({kFrom, static_cast<std::uint32_t>(j), kUp, {x, y, 0}});
    const auto answers = ask(renderer.state(), kSample, renderer.state().light_list.kinds[j], questions);
    for (std::size_t i = 0; i < questions.size(); ++i) {
      const glm::uvec3 bits = questions[i].bits;
      const auto expected = lit.lights.sample(j, kFrom, kUp, {unit(bits.x), unit(bits.y)});
      if (!expected) {  // a direction along the surface
        EXPECT_LT(answers[i].a.w, 1e-3) << j << " " << bits.x << " " << bits.y;
        continue;
      }
      EXPECT_LT(glm::distance(expected->direction, dvec3(answers[i].a)), 5e-4)
          << j << " " << bits.x << " " << bits.y;
      EXPECT_NEAR(answers[i].a.w, expected->pdf, 2e-4 * expected->pdf + 1e-4)
          << j << " " << bits.x << " " << bits.y;
    }
  }
}

}  // namespace
}  // namespace capcon
