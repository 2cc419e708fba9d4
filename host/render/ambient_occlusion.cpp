#include "render/ambient_occlusion.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <chrono>

#include "base/error.h"
#include "render/dispatch.h"
#include "render/sample_order.h"

namespace capcon {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

glm::vec4 with_word(glm::dvec3 v, std::uint32_t w) {
  return {glm::vec3(v), std::bit_cast<float>(w)};
}

KernelVariant occlusion_variant(std::uint32_t sampler_id, bool ordered) {
  return {"occlusion", {{layout::kSpecSampler, sampler_id}, {layout::kSpecOrdered, ordered ? 1 : 0}}};
}

/// One job under way.
class Pass {
 public:
  Pass(RendererState& state, const AmbientOcclusionJob& job, int first_row, int rows,
       const std::function<void(double)>& on_progress)
      : s_(state), job_(job), on_progress_(on_progress) {
    const auto width = static_cast<std::uint32_t>(state.film.width);
    first_ = width * static_cast<std::uint32_t>(first_row);
    pixels_ = width * static_cast<std::uint32_t>(rows);
    result_.image = Image(state.film.width, rows, 1);
  }

  RenderResult run() {
    auto start = Clock::now();
    const auto sampler = make_sampler(job_.sampler, job_.samples, job_.seed);
    std::vector<SampleDomain> domains = {SampleDomain::disk};
    if (job_.position == PixelPosition::jittered) domains.push_back(SampleDomain::square);
    tables_ = sampler->tables(domains);
    stride_ = sampler->split().point_stride;
    const bool jittered = job_.position == PixelPosition::jittered;
    // All samples of a pixel are added up, so that their order is free; not so where each has a place in the
    // pixel.
    const std::vector<glm::uvec4> order = jittered ? std::vector<glm::uvec4>() : sample_order(*sampler);
    s_.set_sampler(tables_, order);
    result_.timings.wall["points"] = seconds_since(start);
    if (jittered) s_.set_image_sampler(tables_);
    primary_ = &s_.kernel(s_.primary_variant(jittered, tables_.id, PixelFilter::box));
    occlusion_ = &s_.kernel(occlusion_variant(tables_.id, !order.empty()));
    result_.timings.wall["compile"] = s_.kernels.take_compile_seconds();
    result_.first_dispatch = Clock::now();
    for (std::uint32_t done = 0; done < pixels_; done += band_pixels_) {
      band_ = first_ + done;
      band_pixels_ = static_cast<std::uint32_t>(std::min<std::size_t>(s_.band_pixels, pixels_ - done));
      band(jittered);
      resolve(done);
    }
    result_.rays = std::uint64_t(pixels_) * job_.samples;
    result_.device = s_.description.name;
    return std::move(result_);
  }

 private:
  /// Pixels that the device can hold at a time.
  void band(bool jittered) {
    s_.counts.clear();
    if (!jittered) {
      primary(0);
      occlusion(0, job_.samples);
      return;
    }
    for (std::uint32_t i = 0; i < job_.samples; ++i) {
      primary(i);
      occlusion(i, 1);
    }
  }

  void primary(std::uint32_t sample_index) {
    layout::PrimaryConstants push{};
    push.tree = s_.tree;
    push.eye = with_word(s_.view.eye, static_cast<std::uint32_t>(s_.film.width));
    push.across = with_word(s_.view.across, band_);
    push.down = with_word(s_.view.down, job_.position == PixelPosition::jittered ? 1 : 0);
    push.words = words();
    push.words.z = stride_;
    push.seed = job_.seed;
    push.count = job_.samples;
    push.sample_index = sample_index;
    for (std::uint64_t first = 0; first < band_pixels_; first += kBatchLanes) {
      const auto batch =
          static_cast<std::uint32_t>(std::min<std::uint64_t>(kBatchLanes, band_pixels_ - first));
      push.first_pixel = band_ + static_cast<std::uint32_t>(first);
      push.corner = with_word(s_.view.corner, batch);
      submit(*primary_, &push, groups_for(batch), "primary");
    }
  }

  void occlusion(std::uint32_t first_sample, std::uint32_t samples) {
    layout::OcclusionConstants push{};
    push.tree = s_.tree;
    push.words = words();
    push.seed = job_.seed;
    push.count = job_.samples;
    push.band = band_;
    push.radius = static_cast<float>(std::min(job_.radius, 3e38));
    const std::uint32_t part = std::min<std::uint64_t>(samples, kBatchLanes);
    const auto batch_pixels = static_cast<std::uint32_t>(std::max<std::uint64_t>(1, kBatchLanes / part));
    for (std::uint32_t from = 0; from < samples; from += part) {
      push.first_sample = first_sample + from;
      push.samples = std::min(part, samples - from);
      for (std::uint32_t first = 0; first < band_pixels_; first += batch_pixels) {
        push.first_pixel = band_ + first;
        push.pixel_count = std::min(batch_pixels, band_pixels_ - first);
        const std::uint32_t groups = groups_for(std::uint64_t(push.pixel_count) * push.samples);
        push.group_stride = spreading_stride(groups);
        submit(*occlusion_, &push, groups, "occlusion");
        done_ += static_cast<double>(push.pixel_count) * push.samples;
        if (on_progress_) on_progress_(done_ / (static_cast<double>(pixels_) * job_.samples));
      }
    }
  }

  void submit(const gpu::Kernel& kernel, const void* push, std::uint32_t groups, const std::string& stage) {
    const auto start = Clock::now();
    gpu::Commands commands(s_.device);
    commands.dispatch(kernel, push, groups, stage);
    commands.submit_and_wait();
    for (const auto& time : commands.times()) result_.timings.device[time.stage] += time.seconds;
    result_.timings.wall[stage] += seconds_since(start);
  }

  /// Counts become fractions: one division a pixel, on the host, from integers that no order of adding can
  /// change.
  void resolve(std::uint32_t first) {
    const auto start = Clock::now();
    std::vector<std::uint32_t> counts(band_pixels_);
    s_.counts.download(counts.data(), 4 * counts.size());
    for (std::size_t i = 0; i < counts.size(); ++i) {
      result_.image.pixels[first + i] = static_cast<float>(static_cast<double>(counts[i]) / job_.samples);
    }
    result_.timings.wall["resolve"] += seconds_since(start);
  }

  glm::uvec4 words() const {
    return {tables_.constants[0], tables_.constants[1], tables_.constants[2], tables_.constants[3]};
  }

  RendererState& s_;
  const AmbientOcclusionJob& job_;
  const std::function<void(double)>& on_progress_;
  std::uint32_t first_ = 0, pixels_ = 0;      // of the rows asked for
  std::uint32_t band_ = 0, band_pixels_ = 0;  // of those on the device
  SamplerTables tables_;
  std::uint32_t stride_ = 1;
  gpu::Kernel* primary_ = nullptr;
  gpu::Kernel* occlusion_ = nullptr;
  RenderResult result_;
  double done_ = 0;
};

}  // namespace

std::vector<KernelVariant> ambient_occlusion_kernels(const RendererState& state,
                                                     const AmbientOcclusionJob& job) {
  const bool jittered = job.position == PixelPosition::jittered;
  const auto sampler = make_sampler(job.sampler, job.samples, job.seed);
  const std::uint32_t id = sampler->tables({}).id;
  return {state.primary_variant(jittered, id, PixelFilter::box),
          occlusion_variant(id, !jittered && !sample_order(*sampler).empty())};
}

RenderResult render_ambient_occlusion(RendererState& state, const AmbientOcclusionJob& job, int first_row,
                                      int rows, const std::function<void(double)>& on_progress) {
  if (job.samples == 0) throw InputError("the number of samples must be at least 1");
  if (!(job.radius > 0)) throw InputError("the occlusion radius must be above 0 (or inf)");
  assert(first_row >= 0 && rows > 0 && first_row + rows <= state.film.height);
  return Pass(state, job, first_row, rows, on_progress).run();
}

}  // namespace capcon
