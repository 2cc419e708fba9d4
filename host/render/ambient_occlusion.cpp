#include "render/ambient_occlusion.h"

#include <algorithm>
#include <cassert>
#include <tuple>

#include "base/error.h"
#include "render/pass.h"
#include "render/sample_order.h"

namespace capcon {
namespace {

KernelVariant occlusion_variant(const RendererState& state, std::uint32_t sampler_id, bool ordered) {
  KernelVariant variant{"occlusion", state.ray_queue.constants()};
  variant.constants[layout::kSpecSampler] = sampler_id;
  variant.constants[layout::kSpecOrdered] = ordered ? 1 : 0;
  return variant;
}

/// One job under way.
class AmbientOcclusionPass : Pass {
 public:
  AmbientOcclusionPass(RendererState& state, const AmbientOcclusionJob& job, int first_row, int rows,
                       const std::function<void(double)>& on_progress)
      : Pass(state, first_row, rows, 1, on_progress), job_(job) {
    std::tie(from_, end_) = job.share.of(job.samples);
  }

  RenderResult run() {
    auto start = Clock::now();
    const auto sampler = make_sampler(job_.sampler, job_.samples, job_.seed, 1, s_.film.width);
    std::vector<SampleDomain> domains = {SampleDomain::disk};
    if (job_.position == PixelPosition::jittered) domains.push_back(SampleDomain::square);
    tables_ = sampler->tables(domains);
    image_tables_ = tables_;
    image_tables_.constants[2] = sampler->split().point_stride;
    const bool jittered = job_.position == PixelPosition::jittered;
    // All samples of a pixel are added up, so that their order is free; not so where each has a place in the
    // pixel.
    const std::vector<glm::uvec4> order = jittered ? std::vector<glm::uvec4>() : sample_order(*sampler);
    s_.set_sampler(tables_, order);
    result_.timings.wall["points"] = seconds_since(start);
    if (jittered) s_.set_image_sampler(tables_);
    primary_ = &s_.kernel(s_.primary_variant(jittered, tables_.id, PixelFilter::box));
    occlusion_ = &s_.kernel(occlusion_variant(s_, tables_.id, !order.empty()));
    result_.timings.wall["compile"] = s_.kernels.take_compile_seconds();
    result_.first_dispatch = Clock::now();
    each_band([&](std::uint32_t first) {
      band(jittered);
      resolve(first);
    });
    result_.rays = std::uint64_t(pixels_) * (end_ - from_);
    return std::move(result_);
  }

 private:
  /// Pixels that the device can hold at a time.
  void band(bool jittered) {
    s_.counts.clear();
    if (!jittered) {
      primary(*primary_, image_tables_, false, job_.seed, job_.samples, 0);
      occlusion(from_, end_ - from_);
      return;
    }
    for (std::uint32_t i = from_; i < end_; ++i) {
      primary(*primary_, image_tables_, true, job_.seed, job_.samples, i);
      occlusion(i, 1);
    }
  }

  void occlusion(std::uint32_t first_sample, std::uint32_t samples) {
    layout::OcclusionConstants push{};
    push.tree = s_.tree;
    push.words = words(tables_);
    push.seed = job_.seed;
    push.count = job_.samples;
    push.band = band_;
    push.radius = static_cast<float>(std::min(job_.radius * s_.placement.scale, 3e38));
    const auto lanes = [&] { return batches_.lanes(*occlusion_); };
    for (std::uint32_t from = 0; from < samples; from += push.samples) {
      push.first_sample = first_sample + from;
      push.samples =
          static_cast<std::uint32_t>(std::min<std::uint64_t>({samples - from, kMostSamples, lanes()}));
      each_piece([&] { return lanes() / push.samples; },
                 [&](std::uint32_t first, std::uint32_t pixels) {
                   push.first_pixel = band_ + first;
                   push.pixel_count = pixels;
                   const std::uint64_t rays = std::uint64_t(pixels) * push.samples;
                   const std::uint32_t groups = s_.ray_queue.deal(push, rays);
                   do {
                     submit(*occlusion_, &push, groups, "occlusion", push.resumed == 0 ? rays : 0);
                   } while (s_.ray_queue.left(push));
                   progress(static_cast<double>(rays), static_cast<double>(pixels_) * (end_ - from_));
                 });
    }
  }

  /// Counts become fractions: one division a pixel, on the host, from integers that no order of adding can
  /// change.
  void resolve(std::uint32_t first) {
    const auto start = Clock::now();
    std::vector<std::uint32_t> counts(band_pixels_);
    s_.counts.download(counts.data(), 4 * counts.size());
    for (std::size_t i = 0; i < counts.size(); ++i) {
      put(first + i, counts[i], 0, job_.share, job_.samples);
    }
    result_.timings.wall["resolve"] += seconds_since(start);
  }

  const AmbientOcclusionJob& job_;
  std::uint32_t from_ = 0, end_ = 0;  // samples of the job's share
  SamplerTables tables_, image_tables_;
  gpu::Kernel* primary_ = nullptr;
  gpu::Kernel* occlusion_ = nullptr;
};

}  // namespace

std::vector<KernelVariant> ambient_occlusion_kernels(const RendererState& state,
                                                     const AmbientOcclusionJob& job) {
  const bool jittered = job.position == PixelPosition::jittered;
  const auto sampler = make_sampler(job.sampler, job.samples, job.seed, 1, state.film.width);
  const std::uint32_t id = sampler->tables({}).id;
  return {state.primary_variant(jittered, id, PixelFilter::box),
          occlusion_variant(state, id, !jittered && !sample_order(*sampler).empty())};
}

RenderResult render_ambient_occlusion(RendererState& state, const AmbientOcclusionJob& job, int first_row,
                                      int rows, const std::function<void(double)>& on_progress) {
  if (job.samples == 0) throw InputError("the number of samples must be at least 1");
  if (!(job.radius > 0)) throw InputError("the occlusion radius must be above 0 (or inf)");
  assert(first_row >= 0 && rows > 0 && first_row + rows <= state.film.height);
  return AmbientOcclusionPass(state, job, first_row, rows, on_progress).run();
}

}  // namespace capcon
