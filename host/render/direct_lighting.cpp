#include "render/direct_lighting.h"

#include <algorithm>
#include <cassert>

#include "base/error.h"
#include "render/pass.h"
#include "render/sample_order.h"

namespace capcon {
namespace {

/// Samples of a pixel in one dispatch: a thread of resolve.comp adds them up in one loop.
constexpr std::uint32_t kMostSamples = 1u << 14;

std::uint32_t strategy_constant(Strategy strategy) {
  if (strategy == Strategy::power) return layout::kStrategyPower;
  return strategy == Strategy::balance ? layout::kStrategyBalance : layout::kStrategyOne;
}

/// The integrator's points: all of a pixel as parts of one set, or a set a part.
std::unique_ptr<Sampler> integrator_sampler(const DirectLightingJob& job) {
  return job.partition ? make_sampler(job.sampler, job.samples(), job.seed, job.image_samples)
                       : make_sampler(job.sampler, job.integrator_samples, job.seed);
}

/// The domains of the BSDF's points and of each light's (docs/direct.md).
std::vector<SampleDomain> domains_of(const std::vector<std::uint32_t>& kinds) {
  const auto any = [&](std::initializer_list<std::uint32_t> of) {
    return std::find_first_of(kinds.begin(), kinds.end(), of.begin(), of.end()) != kinds.end();
  };
  std::vector<SampleDomain> domains = {SampleDomain::disk};
  if (any({layout::kLightRectangle, layout::kLightTriangles})) domains.push_back(SampleDomain::square);
  if (any({layout::kLightMap, layout::kLightSphere})) domains.push_back(SampleDomain::cylinder);
  return domains;
}

/// Whether light samples, and BSDF samples, are of use.
bool uses_lights(const RendererState& s, const DirectLightingJob& job) {
  return job.strategy != Strategy::bsdf && !s.light_list.kinds.empty();
}
bool uses_bsdf(const RendererState& s, const DirectLightingJob& job) {
  const auto& kinds = s.light_list.kinds;
  const auto findable = [](std::uint32_t kind) { return kind <= layout::kLightConstant; };
  return job.strategy != Strategy::lights && std::any_of(kinds.begin(), kinds.end(), findable);
}

/// All samples of a pixel see one surface and are added up, so that their order is free; not where parts have
/// places of their own, nor where a part is a set of its own, which the order does not know.
std::vector<glm::uvec4> order_of(const DirectLightingJob& job, const Sampler& sampler) {
  const bool is_free = job.position == PixelPosition::centre && job.partition;
  return is_free ? sample_order(sampler) : std::vector<glm::uvec4>();
}

/// Whether one sample is as good as many.
bool is_single(std::uint32_t kind) {
  return kind == layout::kLightDistant || kind == layout::kLightPoint;
}

KernelVariant light_variant(const DirectLightingJob& job, std::uint32_t sampler_id, std::uint32_t kind,
                            bool ordered) {
  return {"light_samples",
          {{layout::kSpecSampler, sampler_id},
           {layout::kSpecLight, kind},
           {layout::kSpecOrdered, ordered ? 1 : 0},
           {layout::kSpecStrategy, strategy_constant(job.strategy)}}};
}
KernelVariant bsdf_variant(const DirectLightingJob& job, std::uint32_t sampler_id, bool ordered) {
  return {"bsdf_samples",
          {{layout::kSpecSampler, sampler_id},
           {layout::kSpecOrdered, ordered ? 1 : 0},
           {layout::kSpecStrategy, strategy_constant(job.strategy)}}};
}

/// One job under way.
class DirectLightingPass : Pass {
 public:
  DirectLightingPass(RendererState& state, const DirectLightingJob& job, int first_row, int rows,
                     const std::function<void(double)>& on_progress)
      : Pass(state, first_row, rows, 3, on_progress),
        job_(job),
        jittered_(job.position == PixelPosition::jittered) {}

  RenderResult run() {
    auto start = Clock::now();
    make_points();
    result_.timings.wall["points"] = seconds_since(start);
    s_.need_samples(kBatchLanes);
    make_kernels();
    result_.timings.wall["compile"] = s_.kernels.take_compile_seconds();
    result_.first_dispatch = Clock::now();
    each_band([&](std::uint32_t first) {
      s_.sums.clear();
      if (jittered_) {
        for (std::uint32_t p = 0; p < job_.image_samples; ++p)
          image_sample(p, p * job_.integrator_samples, job_.integrator_samples);
      } else {
        image_sample(0, 0, job_.samples());
      }
      resolve(first);
    });
    const std::uint64_t singles = (lights_.size() - sampled_) * (jittered_ ? job_.image_samples : 1);
    result_.rays = pixels_ * (job_.samples() * (sampled_ + (bsdf_ ? 1 : 0)) + singles);
    return std::move(result_);
  }

 private:
  void make_points() {
    const auto sampler = integrator_sampler(job_);
    tables_ = sampler->tables(domains_of(s_.light_list.kinds));
    order_ = order_of(job_, *sampler);
    s_.set_sampler(tables_, order_);
    const Split& split = sampler->split();
    split_ = {job_.image_samples, job_.integrator_samples, split.part_stride, split.point_stride};
    if (!jittered_) return;
    const auto image = make_sampler(job_.sampler, job_.image_samples, job_.seed);
    image_tables_ = image->tables({SampleDomain::square});
    image_tables_.constants[2] = image->split().point_stride;
    s_.set_image_sampler(image_tables_);
  }

  void make_kernels() {
    primary_ = &s_.kernel(s_.primary_variant(jittered_, tables_.id, job_.filter));
    if (uses_lights(s_, job_)) {
      for (const std::uint32_t kind : s_.light_list.kinds)
        lights_.push_back(&s_.kernel(light_variant(job_, tables_.id, kind, !order_.empty())));
    }
    for (std::size_t j = 0; j < lights_.size(); ++j) sampled_ += is_single(s_.light_list.kinds[j]) ? 0 : 1;
    if (uses_bsdf(s_, job_)) bsdf_ = &s_.kernel(bsdf_variant(job_, tables_.id, !order_.empty()));
    sum_ = &s_.kernel({"resolve", {}});
    emission_ = &s_.kernel({"emission", {}});
  }

  /// The integrator samples first ... first + count - 1 of each pixel of the band, from its image sample p.
  void image_sample(std::uint32_t p, std::uint32_t first, std::uint32_t count) {
    primary(*primary_, image_tables_, jittered_, job_.seed, job_.image_samples, p);
    emission(static_cast<float>(count));
    if (lights_.empty() && !bsdf_) return;
    single_samples(first, count);
    if (sampled_ == 0 && !bsdf_) return;
    const std::uint32_t part = std::min(count, kMostSamples);
    const std::uint64_t batch_pixels = std::max<std::uint64_t>(1, kBatchLanes / part);
    for (std::uint32_t from = 0; from < count; from += part) {
      const std::uint32_t samples = std::min(part, count - from);
      each_piece(batch_pixels, [&](std::uint32_t pixel, std::uint32_t pixels) {
        samples_of(band_ + pixel, pixels, first + from, samples);
        progress(static_cast<double>(pixels) * samples, static_cast<double>(pixels_) * job_.samples());
      });
    }
  }

  /// Point and distant lights: all samples are the same, and one stands for them.
  void single_samples(std::uint32_t first, std::uint32_t count) {
    if (sampled_ == lights_.size()) return;
    each_piece(kBatchLanes, [&](std::uint32_t pixel, std::uint32_t pixels) {
      samples_of(band_ + pixel, pixels, first, 1, static_cast<float>(count));
    });
  }

  /// With a weight above 0: the single samples alone.
  void samples_of(std::uint32_t first_pixel, std::uint32_t pixels, std::uint32_t first, std::uint32_t samples,
                  float weight = 0) {
    layout::DirectConstants push{};
    push.tree = s_.tree;
    push.words = words(tables_);
    push.split = split_;
    push.eye = with_word(s_.view.eye, job_.seed);
    push.first_pixel = first_pixel;
    push.pixel_count = pixels;
    push.first_sample = first;
    push.samples = samples;
    push.band = band_;
    push.lights = static_cast<std::uint32_t>(s_.light_list.kinds.size());
    const std::uint32_t groups = groups_for(std::uint64_t(pixels) * samples);
    push.group_stride = spreading_stride(groups);
    push.flags = layout::kDirectFirst | (job_.partition ? 0 : layout::kDirectSeparate) |
                 (jittered_ && job_.image_samples > 1 ? layout::kDirectPlaces : 0);
    push.weight = weight > 0 ? weight : 1;
    for (std::size_t j = 0; j < lights_.size(); ++j) {
      if (is_single(s_.light_list.kinds[j]) != (weight > 0)) continue;
      push.light = static_cast<std::uint32_t>(j);
      submit(*lights_[j], &push, groups, "light samples");
      push.flags &= ~layout::kDirectFirst;
    }
    if (bsdf_ && weight == 0) {
      push.light = s_.light_list.area_lights;
      submit(*bsdf_, &push, groups, "bsdf samples");
    }
    const layout::ResolveConstants sum{first_pixel, pixels, samples, band_};
    submit(*sum_, &sum, groups_for(pixels), "resolve");
  }

  void emission(float weight) {
    const auto lights = static_cast<std::uint32_t>(s_.light_list.kinds.size());
    if (lights == 0) return;
    layout::EmissionConstants push{band_,  band_pixels_, band_, s_.light_list.area_lights,
                                   lights, weight,       0,     0};
    submit(*emission_, &push, groups_for(band_pixels_), "emission");
  }

  void resolve(std::uint32_t first) {
    const auto start = Clock::now();
    std::vector<glm::vec4> sums(2 * std::size_t(band_pixels_));
    s_.sums.download(sums.data(), 16 * sums.size());
    for (std::size_t i = 0; i < band_pixels_; ++i) {
      for (int c = 0; c < 3; ++c) {
        const double sum = static_cast<double>(sums[2 * i][c]) - static_cast<double>(sums[2 * i + 1][c]);
        result_.image.pixels[3 * (first + i) + c] = static_cast<float>(sum / job_.samples());
      }
    }
    result_.timings.wall["resolve"] += seconds_since(start);
  }

  const DirectLightingJob& job_;
  bool jittered_;
  SamplerTables tables_, image_tables_;
  std::vector<glm::uvec4> order_;
  glm::uvec4 split_{1};
  gpu::Kernel *primary_ = nullptr, *bsdf_ = nullptr, *sum_ = nullptr, *emission_ = nullptr;
  std::vector<gpu::Kernel*> lights_;  // one for each light, the same for those of a kind
  std::size_t sampled_ = 0;           // how many of them need more than one sample
};

}  // namespace

RenderResult render_direct_lighting(RendererState& state, const DirectLightingJob& job, int first_row,
                                    int rows, const std::function<void(double)>& on_progress) {
  if (job.image_samples == 0 || job.integrator_samples == 0)
    throw InputError("the number of samples must be at least 1");
  if (std::uint64_t(job.image_samples) * job.integrator_samples > (1u << 24))
    throw InputError("more than 2^24 samples a pixel are too many for one image; average several seeds");
  assert(first_row >= 0 && rows > 0 && first_row + rows <= state.film.height);
  if (!state.features.shading) throw Failure("this renderer was made for ambient occlusion alone");
  return DirectLightingPass(state, job, first_row, rows, on_progress).run();
}

std::vector<KernelVariant> direct_lighting_kernels(const RendererState& state, const DirectLightingJob& job) {
  const bool jittered = job.position == PixelPosition::jittered;
  const auto sampler = integrator_sampler(job);
  const std::uint32_t id = sampler->tables({}).id;
  const bool ordered = !order_of(job, *sampler).empty();
  std::vector<KernelVariant> variants = {state.primary_variant(jittered, id, job.filter)};
  if (uses_lights(state, job)) {
    for (const std::uint32_t kind : state.light_list.kinds)
      variants.push_back(light_variant(job, id, kind, ordered));
  }
  if (uses_bsdf(state, job)) variants.push_back(bsdf_variant(job, id, ordered));
  variants.push_back({"resolve", {}});
  variants.push_back({"emission", {}});
  return variants;
}

}  // namespace capcon
