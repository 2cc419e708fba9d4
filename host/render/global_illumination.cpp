#include "render/global_illumination.h"

#include <algorithm>

#include "base/error.h"
#include "render/direct_lighting.h"
#include "render/gather_pass.h"
#include "render/receivers.h"

namespace capcon {
namespace {

constexpr std::uint32_t kMostLevels = 64;              // surfaces of a chain of compensation rays
constexpr std::uint64_t kCompensationRays = 1u << 17;  // of a batch: they take more room than others

std::uint32_t gather_seed(std::uint32_t seed) {
  return seed ^ 0x67617468u;
}

/// How many sets of compensation rays a pixel has: one for each set of virtual lights, or image sample.
std::uint32_t gather_parts(const GlobalIlluminationJob& job) {
  return job.direct.position == PixelPosition::jittered ? job.direct.image_samples : job.sets_a_pixel();
}

std::unique_ptr<Sampler> gather_sampler(const GlobalIlluminationJob& job, const Film& film) {
  const std::uint32_t parts = gather_parts(job);
  return make_sampler(job.direct.sampler, parts * job.gather, gather_seed(job.direct.seed), parts,
                      film.width);
}

KernelVariant of_receivers(const std::string& name) {
  return {name, {{layout::kSpecReceivers, 1}, {layout::kSpecSampler, layout::kSamplerRandom}}};
}
const KernelVariant kGather{"gather", {}};
KernelVariant compensation_variant(std::uint32_t sampler_id) {
  return {"compensation", {{layout::kSpecSampler, sampler_id}}};
}

/// One job under way.
class GlobalIlluminationPass : public GatherPass {
 public:
  GlobalIlluminationPass(RendererState& state, const GlobalIlluminationJob& job, int first_row, int rows,
                         const std::function<void(double)>& on_progress)
      : GatherPass(state, job.direct, first_row, rows, on_progress),
        igi_(job),
        compensates_(job.clamping == Clamping::compensate),
        limit_(static_cast<float>(job.limit > 0 ? job.limit / (state.placement.scale * state.placement.scale)
                                                : state.geometry_limit)) {
    tells_progress_ = false;
  }

  RenderResult run() {
    lights_ = trace_light_paths(s_, igi_, result_.timings);
    s_.put(s_.virtual_lights, lights_.texels);
    prepare();
    result_.first_dispatch = Clock::now();
    each_band([&](std::uint32_t first) {
      s_.sums.clear();
      more_.assign(3 * std::size_t(band_pixels_), 0);
      if (jittered_) {
        for (std::uint32_t p = from_; p < end_; ++p) image_sample(p);
      } else {
        look(0);
        if (!igi_.only_indirect) direct_light(from_, end_ - from_);
        const std::uint32_t sets = igi_.sets_a_pixel();
        const auto [from, end] = job_.share.of(sets);
        for (std::uint32_t j = from; j < end; ++j) set_light(j, j, 1.0 / sets);
      }
      resolve(first, more_);
    });
    if (!igi_.only_indirect) rays_ += direct_rays();
    result_.rays = rays_ + lights_.rays;
    result_.virtual_lights = lights_.path_and_bounce.size();
    return std::move(result_);
  }

 private:
  void prepare() {
    const auto start = Clock::now();
    make_points();
    if (compensates_) {
      const auto sampler = gather_sampler(igi_, s_.film);
      gather_tables_ = sampler->tables({SampleDomain::disk});
      gather_split_ = sampler->split();
      s_.set_gather_sampler(gather_tables_);
    }
    result_.timings.wall["points"] += seconds_since(start);
    s_.need_samples();
    make_kernels();
    gather_ = &s_.kernel(kGather);
    if (compensates_) {
      s_.need_paths(0, std::max<std::uint64_t>(std::min(s_.most_lanes, kCompensationRays), igi_.gather));
      compensation_ = &s_.kernel(compensation_variant(gather_tables_.id));
      onwards_ = &s_.kernel(of_receivers("compensation"));
      gather_beyond_ = &s_.kernel(of_receivers("gather"));
      sum_beyond_ = &s_.kernel(of_receivers("resolve"));
      direct_ = direct_variants(s_, job_, layout::kSamplerRandom, false, true);
      for (const auto* variants : {&direct_.lights, &direct_.bsdf}) {
        for (const KernelVariant& variant : *variants) direct_kernels_.push_back(&s_.kernel(variant));
      }
    }
    result_.timings.wall["compile"] = s_.kernels.take_compile_seconds();
    std::uint64_t lights = 0;
    const auto [from, end] = job_.share.of(igi_.sets_a_pixel());
    const std::uint32_t looks = jittered_ ? end_ - from_ : end - from;
    lights = lights_.path_and_bounce.size() / igi_.sets * looks;
    all_work_ = std::max(1.0, static_cast<double>(pixels_) * static_cast<double>(lights));
  }

  void image_sample(std::uint32_t p) {
    look(p);
    if (!igi_.only_indirect) direct_light(p * job_.integrator_samples, job_.integrator_samples);
    set_light(p % igi_.sets_a_pixel(), p, 1.0 / job_.image_samples);
  }

  /// The indirect light of what was last looked at, by number j of each pixel's sets, as the share `weight`
  /// of the pixel.
  void set_light(std::uint32_t j, std::uint32_t part, double weight) {
    const float limit = igi_.clamping == Clamping::none ? 3e38f : limit_;
    set_ = j * igi_.block * igi_.block;
    const GatherWork work{
        band_, band_pixels_, band_, set_, igi_.block, static_cast<std::uint32_t>(s_.film.width), limit};
    gather(*gather_, *sum_, work, igi_.two_sided, static_cast<float>(weight * job_.samples()));
    if (compensates_) compensate(part, weight);
  }

  /// What the limit leaves out, by rays from each pixel, and what those meet.
  void compensate(std::uint32_t part, double weight) {
    layout::CompensationConstants push{};
    push.tree = s_.tree;
    push.words = words(gather_tables_);
    push.eye = with_word(s_.view.eye, gather_seed(job_.seed));
    push.band = band_;
    push.part = part;
    push.parts = gather_split_.parts;
    push.part_stride = gather_split_.part_stride;
    push.ray_stride = gather_split_.point_stride;
    push.limit = limit_;
    each_piece([&] { return compensation_lanes() / igi_.gather; },
               [&](std::uint32_t first, std::uint32_t pixels) {
                 push.first_pixel = band_ + first;
                 push.pixel_count = pixels;
                 push.rays = igi_.gather;
                 push.level = 0;
                 Receivers receivers = find(*compensation_, push, nullptr);
                 layout::CompensationConstants on = push;
                 on.first_pixel = on.band = 0;
                 on.rays = 1;
                 for (std::uint32_t level = 1; level <= kMostLevels && receivers.count() > 0; ++level) {
                   light(receivers, level, weight);
                   on.level = level;
                   on.pixel_count = receivers.count();
                   if (level < kMostLevels) receivers = find(*onwards_, on, &receivers);
                 }
               });
  }

  /// Rays that a piece may have, so that neither they nor what follows them take long.
  std::uint64_t compensation_lanes() const {
    std::uint64_t fewest = std::min({batches_.lanes(*compensation_), s_.most_lanes, kCompensationRays});
    fewest = std::min(fewest, batches_.lanes_onwards(*onwards_));
    for (const gpu::Kernel* kernel : direct_kernels_)
      fewest = std::min(fewest, batches_.lanes_onwards(*kernel));
    return fewest;
  }

  Receivers find(gpu::Kernel& kernel, const layout::CompensationConstants& push, const Receivers* before) {
    const std::uint32_t rays = push.pixel_count * push.rays;
    rays_ += rays;
    submit(kernel, &push, groups_for(rays), "compensation");
    std::vector<glm::uvec4> found(6 * std::size_t(rays));
    const auto start = Clock::now();
    s_.found.download(found.data(), 16 * found.size());
    const auto width = static_cast<std::uint32_t>(s_.film.width);
    Receivers receivers = pick_receivers(
        found, igi_.block * igi_.block,
        [&](std::uint32_t pixel) {
          return pixel % width % igi_.block + igi_.block * (pixel / width % igi_.block);
        },
        before);
    result_.timings.wall["compensation"] += seconds_since(start);
    return receivers;
  }

  /// Lights receivers and adds what that is worth to their pixels.
  void light(const Receivers& receivers, std::uint32_t level, double weight) {
    const std::uint32_t count = receivers.count();
    s_.receivers.upload(receivers.surfaces.data(), 16 * receivers.surfaces.size());
    s_.receiver_shading.upload(receivers.shading.data(), 16 * receivers.shading.size());
    std::vector<glm::vec4> sums(2 * std::size_t(count), glm::vec4(0));
    s_.receiver_sums.upload(sums.data(), 16 * sums.size());
    direct_of_receivers(count, level);
    for (std::uint32_t c = 0; c < igi_.block * igi_.block; ++c) {
      const std::uint32_t first = receivers.first[c];
      gather(*gather_beyond_, *sum_beyond_,
             {first, receivers.first[c + 1] - first, 0, set_ + c, 1, 1, limit_}, igi_.two_sided, 1);
    }
    s_.receiver_sums.download(sums.data(), 16 * sums.size());
    for (std::uint32_t r = 0; r < count; ++r) {
      const glm::dvec3 radiance = glm::dvec3(sums[2 * r]) - glm::dvec3(sums[2 * r + 1]);
      const glm::dvec3 value = weight * receivers.weights[r].scale * radiance;
      for (int c = 0; c < 3; ++c) more_[3 * std::size_t(receivers.weights[r].pixel - band_) + c] += value[c];
    }
  }

  /// One sample of each light and one of the BSDF.
  void direct_of_receivers(std::uint32_t count, std::uint32_t level) {
    if (direct_.lights.empty() && direct_.bsdf.empty()) return;
    layout::DirectConstants push{};
    push.tree = s_.tree;
    push.split = {1, 1, 1, 1};
    push.eye = with_word(s_.view.eye, gather_seed(job_.seed));
    push.pixel_count = count;
    push.samples = 1;
    push.lights = static_cast<std::uint32_t>(s_.light_list.kinds.size());
    push.group_stride = 1;
    push.flags = layout::kDirectFirst;
    push.weight = 1;
    push.level = level;
    const std::uint32_t groups = groups_for(count);
    for (std::size_t j = 0; j < direct_.lights.size(); ++j) {
      push.light = static_cast<std::uint32_t>(j);
      submit(s_.kernel(direct_.lights[j]), &push, groups, "compensation");
      push.flags = 0;
    }
    if (!direct_.bsdf.empty()) {
      push.light = s_.light_list.area_lights;
      submit(s_.kernel(direct_.bsdf.front()), &push, groups, "compensation");
    }
    add_up(*sum_beyond_, 0, count, 1, 0);
    rays_ += std::uint64_t(count) * (direct_.lights.size() + direct_.bsdf.size());
  }

  const GlobalIlluminationJob& igi_;
  bool compensates_;
  float limit_;
  SamplerTables gather_tables_;
  Split gather_split_;
  DirectVariants direct_;
  gpu::Kernel *gather_ = nullptr, *compensation_ = nullptr, *onwards_ = nullptr, *gather_beyond_ = nullptr,
              *sum_beyond_ = nullptr;
  std::vector<const gpu::Kernel*> direct_kernels_;  ///< of direct_
  std::uint32_t set_ = 0;                           ///< of the pixel at block (0, 0), the one that lights now
  std::vector<double> more_;
};

}  // namespace

RenderResult render_global_illumination(RendererState& state, const GlobalIlluminationJob& job, int first_row,
                                        int rows, const std::function<void(double)>& on_progress) {
  check_job(job);
  check_direct_job(job.direct);
  if (!state.features.shading) throw Failure("this renderer was made for ambient occlusion alone");
  return GlobalIlluminationPass(state, job, first_row, rows, on_progress).run();
}

std::vector<KernelVariant> global_illumination_kernels(const RendererState& state,
                                                       const GlobalIlluminationJob& job) {
  std::vector<KernelVariant> variants = direct_lighting_kernels(state, job.direct);
  const auto add = [&](const std::vector<KernelVariant>& more) {
    variants.insert(variants.end(), more.begin(), more.end());
  };
  add(light_path_kernels(path_sampler(job)->tables({}).id));
  add({kGather});
  if (job.clamping != Clamping::compensate) return variants;
  add({compensation_variant(gather_sampler(job, state.film)->tables({}).id)});
  add({of_receivers("compensation"), of_receivers("gather"), of_receivers("resolve")});
  const DirectVariants direct = direct_variants(state, job.direct, layout::kSamplerRandom, false, true);
  add(direct.lights);
  add(direct.bsdf);
  return variants;
}

}  // namespace capcon
