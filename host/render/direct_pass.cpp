#include "render/direct_pass.h"

#include <algorithm>
#include <tuple>

#include "render/sample_order.h"

namespace capcon {
namespace {

std::uint32_t strategy_constant(Strategy strategy) {
  if (strategy == Strategy::power) return layout::kStrategyPower;
  return strategy == Strategy::balance ? layout::kStrategyBalance : layout::kStrategyOne;
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

}  // namespace

std::unique_ptr<Sampler> integrator_sampler(const DirectLightingJob& job, const Film& film) {
  return job.partition ? make_sampler(job.sampler, job.samples(), job.seed, job.image_samples, film.width)
                       : make_sampler(job.sampler, job.integrator_samples, job.seed, 1, film.width);
}

// All samples of a pixel see one surface and are added up, so that their order is free; not where parts have
// places of their own, nor where a part is a set of its own, which the order does not know.
std::vector<glm::uvec4> order_of(const DirectLightingJob& job, const Sampler& sampler) {
  const bool is_free = job.position == PixelPosition::centre && job.partition;
  return is_free ? sample_order(sampler) : std::vector<glm::uvec4>();
}

bool is_single(std::uint32_t kind) {
  return kind == layout::kLightDistant || kind == layout::kLightPoint;
}

DirectVariants direct_variants(const RendererState& state, const DirectLightingJob& job,
                               std::uint32_t sampler_id, bool ordered, bool receivers) {
  Constants common = {{layout::kSpecSampler, sampler_id},
                      {layout::kSpecOrdered, ordered ? 1 : 0},
                      {layout::kSpecStrategy, strategy_constant(job.strategy)}};
  if (receivers) common[layout::kSpecReceivers] = 1;
  DirectVariants variants;
  if (uses_lights(state, job)) {
    for (const std::uint32_t kind : state.light_list.kinds) {
      variants.lights.push_back({"light_samples", common});
      variants.lights.back().constants[layout::kSpecLight] = kind;
    }
  }
  if (uses_bsdf(state, job)) variants.bsdf.push_back({"bsdf_samples", common});
  return variants;
}

DirectLightingPass::DirectLightingPass(RendererState& state, const DirectLightingJob& job, int first_row,
                                       int rows, const std::function<void(double)>& on_progress)
    : Pass(state, first_row, rows, 3, on_progress),
      job_(job),
      jittered_(job.position == PixelPosition::jittered) {
  std::tie(from_, end_) = job.share.of(jittered_ ? job.image_samples : job.samples());
}

RenderResult DirectLightingPass::run() {
  const auto start = Clock::now();
  make_points();
  result_.timings.wall["points"] = seconds_since(start);
  s_.need_samples();
  make_kernels();
  result_.timings.wall["compile"] = s_.kernels.take_compile_seconds();
  result_.first_dispatch = Clock::now();
  each_band([&](std::uint32_t first) {
    s_.sums.clear();
    if (jittered_) {
      for (std::uint32_t p = from_; p < end_; ++p) {
        look(p);
        direct_light(p * job_.integrator_samples, job_.integrator_samples);
      }
    } else {
      look(0);
      direct_light(from_, end_ - from_);
    }
    resolve(first);
  });
  result_.rays = direct_rays();
  return std::move(result_);
}

std::uint64_t DirectLightingPass::share_samples() const {
  return std::uint64_t(end_ - from_) * (jittered_ ? job_.integrator_samples : 1);
}

std::uint64_t DirectLightingPass::direct_rays() const {
  const std::uint64_t singles = (lights_.size() - sampled_) * (jittered_ ? end_ - from_ : 1);
  return pixels_ * (share_samples() * (sampled_ + (bsdf_ ? 1 : 0)) + singles);
}

void DirectLightingPass::make_points() {
  const auto sampler = integrator_sampler(job_, s_.film);
  tables_ = sampler->tables(domains_of(s_.light_list.kinds));
  order_ = order_of(job_, *sampler);
  s_.set_sampler(tables_, order_);
  const Split& split = sampler->split();
  split_ = {job_.image_samples, job_.integrator_samples, split.part_stride, split.point_stride};
  if (!jittered_) return;
  const auto image = make_sampler(job_.sampler, job_.image_samples, job_.seed, 1, s_.film.width);
  image_tables_ = image->tables({SampleDomain::square});
  image_tables_.constants[2] = image->split().point_stride;
  s_.set_image_sampler(image_tables_);
}

void DirectLightingPass::make_kernels() {
  primary_ = &s_.kernel(s_.primary_variant(jittered_, image_tables_.id, job_.filter));
  const DirectVariants variants = direct_variants(s_, job_, tables_.id, !order_.empty(), false);
  for (const KernelVariant& variant : variants.lights) lights_.push_back(&s_.kernel(variant));
  for (std::size_t j = 0; j < lights_.size(); ++j) sampled_ += is_single(s_.light_list.kinds[j]) ? 0 : 1;
  for (const KernelVariant& variant : variants.bsdf) bsdf_ = &s_.kernel(variant);
  sum_ = &s_.kernel({"resolve", {}});
  emission_ = &s_.kernel({"emission", {}});
}

void DirectLightingPass::look(std::uint32_t p) {
  primary(*primary_, image_tables_, jittered_, job_.seed, job_.image_samples, p);
}

void DirectLightingPass::direct_light(std::uint32_t first, std::uint32_t count) {
  if (count == 0) return;
  emission(static_cast<float>(count));
  if (lights_.empty() && !bsdf_) return;
  single_samples(first, count);
  if (sampled_ == 0 && !bsdf_) return;
  const auto lanes = [&] { return batch_lanes(false); };
  for (std::uint32_t from = 0, samples = 0; from < count; from += samples) {
    samples = static_cast<std::uint32_t>(std::min<std::uint64_t>({count - from, kMostSamples, lanes()}));
    each_piece([&] { return lanes() / samples; },
               [&](std::uint32_t pixel, std::uint32_t pixels) {
                 samples_of(band_ + pixel, pixels, first + from, samples);
                 if (tells_progress_)
                   progress(static_cast<double>(pixels) * samples,
                            static_cast<double>(pixels_) * static_cast<double>(share_samples()));
               });
  }
}

/// Point and distant lights: all samples are the same, and one stands for them.
void DirectLightingPass::single_samples(std::uint32_t first, std::uint32_t count) {
  if (sampled_ == lights_.size()) return;
  each_piece([&] { return batch_lanes(true); },
             [&](std::uint32_t pixel, std::uint32_t pixels) {
               samples_of(band_ + pixel, pixels, first, 1, static_cast<float>(count));
             });
}

/// Of the lights that one sample is enough for, or of the others and the BSDF.
std::uint64_t DirectLightingPass::batch_lanes(bool single) const {
  std::uint64_t fewest = single ? batches_.lanes({}) : batches_.lanes({bsdf_});
  for (std::size_t j = 0; j < lights_.size(); ++j) {
    if (is_single(s_.light_list.kinds[j]) == single) fewest = std::min(fewest, batches_.lanes(*lights_[j]));
  }
  return fewest;
}

/// With a weight above 0: the single samples alone.
void DirectLightingPass::samples_of(std::uint32_t first_pixel, std::uint32_t pixels, std::uint32_t first,
                                    std::uint32_t samples, float weight) {
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
  add_up(*sum_, first_pixel, pixels, samples, band_);
}

void DirectLightingPass::emission(float weight) {
  const auto lights = static_cast<std::uint32_t>(s_.light_list.kinds.size());
  if (lights == 0) return;
  layout::EmissionConstants push{0, 0, band_, s_.light_list.area_lights, lights, weight, 0, 0};
  each_piece([&] { return batches_.lanes(*emission_); },
             [&](std::uint32_t first, std::uint32_t pixels) {
               push.first_pixel = band_ + first;
               push.pixel_count = pixels;
               submit(*emission_, &push, groups_for(pixels), "emission");
             });
}

void DirectLightingPass::add_up(gpu::Kernel& kernel, std::uint32_t first_pixel, std::uint32_t pixels,
                                std::uint32_t columns, std::uint32_t band, float weight) {
  const layout::ResolveConstants sum{first_pixel, pixels, columns, band, weight, 0, 0, 0};
  submit(kernel, &sum, groups_for(pixels), "resolve");
}

void DirectLightingPass::resolve(std::uint32_t first, const std::vector<double>& more) {
  const auto start = Clock::now();
  std::vector<glm::vec4> sums(2 * std::size_t(band_pixels_));
  s_.sums.download(sums.data(), 16 * sums.size());
  for (std::size_t i = 0; i < band_pixels_; ++i) {
    for (int c = 0; c < 3; ++c) {
      const double sum = static_cast<double>(sums[2 * i][c]) - static_cast<double>(sums[2 * i + 1][c]);
      const std::size_t value = 3 * (first + i) + c;
      put(value, sum, more.empty() ? 0 : more[3 * i + c], job_.share, job_.samples());
    }
  }
  result_.timings.wall["resolve"] += seconds_since(start);
}

}  // namespace capcon
