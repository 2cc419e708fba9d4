#include "stability/image_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

#include "base/file.h"
#include "reference/reference.h"
#include "render/renderer.h"
#include "stability/deviation.h"

namespace capcon::stability {
namespace {

std::string flags_of(const DirectLightingJob& job) {
  return fmt::format("--sampler {} --samples {}", job.sampler, job.integrator_samples);
}

std::string_view name_of(Clamping clamping) {
  return clamping == Clamping::none ? "none" : clamping == Clamping::clamp ? "clamp" : "compensate";
}

}  // namespace

std::string command_of(const std::string& scene, const Job& job) {
  std::string command = "capcon render " + scene;
  if (const auto* occlusion = std::get_if<AmbientOcclusionJob>(&job)) {
    command += fmt::format(" --sampler {} --samples {} --radius {}", occlusion->sampler, occlusion->samples,
                           occlusion->radius);
  } else if (const auto* direct = std::get_if<DirectLightingJob>(&job)) {
    command += " --integrator direct " + flags_of(*direct);
  } else if (const auto* igi = std::get_if<GlobalIlluminationJob>(&job)) {
    command += fmt::format(" --integrator igi {} --paths {} --sets {} --clamping {}", flags_of(igi->direct),
                           igi->paths, igi->sets, name_of(igi->clamping));
    if (igi->limit > 0) command += fmt::format(" --limit {}", igi->limit);
  }
  return command;
}

std::string path_of(const ImageCase& c, const Workshop& workshop) {
  return (std::filesystem::path(workshop.folder) / (c.name + ".pbrt")).string();
}

std::string write_case(const ImageCase& c, const Workshop& workshop) {
  namespace fs = std::filesystem;
  const fs::path folder = workshop.folder;
  fs::create_directories(folder);
  for (const auto& [name, bytes] : c.files) write_file(folder / name, bytes);
  for (const auto& [name, image] : c.images) write_exr(folder / name, image);
  write_file(path_of(c, workshop), c.scene);
  return path_of(c, workshop);
}

Scene read_case(const ImageCase& c, const Workshop& workshop) {
  const bool shading = needs_shading(c.job);
  return read_scene(write_case(c, workshop), {shading, shading, shading});
}

RendererOptions renderer_options(const Job& job, const Workshop& workshop) {
  RendererOptions options;
  options.device = workshop.device;
  options.shading = needs_shading(job);
  return options;
}

Check run_case(const ImageCase& c, const Workshop& workshop) {
  const auto start = std::chrono::steady_clock::now();
  const Scene scene = read_case(c, workshop);
  Renderer renderer(scene, renderer_options(c.job, workshop));
  const RenderResult result = renderer.render(c.job);
  const Reference reference(scene);
  // The reference gathers from the device's VPLs: paths part ways at edges, which is not what is asked here.
  const auto* igi = std::get_if<GlobalIlluminationJob>(&c.job);
  const Image truth =
      (igi ? reference.render(*igi, renderer.virtual_lights(*igi)) : reference.render(c.job)).image;
  const Deviation d = deviation(result.image, truth, c.bound.tolerance);
  Check check;
  check.group = c.group;
  check.name = c.name;
  check.what = c.what;
  check.values = d.pixels;
  check.non_finite = d.non_finite;
  check.largest = d.largest;
  check.beyond = d.beyond;
  check.measured = fmt::format("median {:.1e}, mean {:+.1e}", d.median, d.bias);
  check.bound = fmt::format("{:g} % beyond {:g}, mean within {:g}", 100 * c.bound.share, c.bound.tolerance,
                            c.bound.bias);
  check.reason = c.bound.reason;
  check.passed = d.non_finite == 0 &&
                 static_cast<double>(d.beyond) <= c.bound.share * static_cast<double>(d.pixels) &&
                 std::abs(d.bias) <= c.bound.bias;
  check.device = result.device;
  check.command = command_of(path_of(c, workshop), c.job);
  check.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return check;
}

AmbientOcclusionJob occlusion(double radius) {
  AmbientOcclusionJob job;
  job.radius = radius;
  return job;
}

DirectLightingJob direct() {
  DirectLightingJob job;
  job.sampler = "sobol-owen";
  return job;
}

GlobalIlluminationJob igi(Clamping clamping) {
  GlobalIlluminationJob job;
  job.direct = direct();
  job.direct.integrator_samples = 4;
  job.sampler = "sobol-owen";
  job.paths = 64;
  job.sets = 2;
  job.clamping = clamping;
  return job;
}

}  // namespace capcon::stability
