#pragma once

#include <vector>

#include "render/pass.h"

namespace capcon {

/// The integrator's points: all of a pixel as parts of one set, or a set a part.
std::unique_ptr<Sampler> integrator_sampler(const DirectLightingJob& job, const Film& film);

/// The specialisations of the kernels of direct lighting.
struct DirectVariants {
  std::vector<KernelVariant> lights;  ///< one for each light; none where light samples are of no use
  std::vector<KernelVariant> bsdf;    ///< one, or none where BSDF samples find nothing
};
/// `ordered`: a pixel's samples are taken in an order of their own. `receivers`: of surfaces that rays met.
DirectVariants direct_variants(const RendererState& state, const DirectLightingJob& job,
                               std::uint32_t sampler_id, bool ordered, bool receivers);
/// The order of a pixel's samples; empty: as they come.
std::vector<glm::uvec4> order_of(const DirectLightingJob& job, const Sampler& sampler);
/// Whether one sample of a light of this kind is as good as many.
bool is_single(std::uint32_t light_kind);

/// A job of direct lighting under way (docs/direct.md), or that part of another.
class DirectLightingPass : public Pass {
 public:
  DirectLightingPass(RendererState& state, const DirectLightingJob& job, int first_row, int rows,
                     const std::function<void(double)>& on_progress);
  RenderResult run();

 protected:
  void make_points();
  void make_kernels();
  /// What the band's pixels see at image sample p.
  void look(std::uint32_t p);
  /// What comes straight from lights: emission, and the integrator samples first ... first + count - 1 of
  /// each pixel of the band, from what was last looked at.
  void direct_light(std::uint32_t first, std::uint32_t count);
  /// The band's pixels, `first` the first of those asked for, from their sums; and of the host's own `more`,
  /// three a pixel, where there is any.
  void resolve(std::uint32_t first, const std::vector<double>& more = {});
  /// Adds `columns` samples of each of these pixels, times a weight, to their sums.
  void add_up(gpu::Kernel& kernel, std::uint32_t first_pixel, std::uint32_t pixels, std::uint32_t columns,
              std::uint32_t band, float weight = 1);
  std::uint64_t direct_rays() const;
  /// Integrator samples of a pixel in the job's share.
  std::uint64_t share_samples() const;

  const DirectLightingJob& job_;
  bool jittered_;
  std::uint32_t from_ = 0, end_ = 0;  ///< the job's share of image samples, or at centres of the integrator's
  bool tells_progress_ = true;
  gpu::Kernel* sum_ = nullptr;

 private:
  void single_samples(std::uint32_t first, std::uint32_t count);
  void samples_of(std::uint32_t first_pixel, std::uint32_t pixels, std::uint32_t first, std::uint32_t samples,
                  float weight = 0);
  void emission(float weight);
  std::uint64_t batch_lanes(bool single) const;

  SamplerTables tables_, image_tables_;
  std::vector<glm::uvec4> order_;
  glm::uvec4 split_{1};
  gpu::Kernel *primary_ = nullptr, *bsdf_ = nullptr, *emission_ = nullptr;
  std::vector<gpu::Kernel*> lights_;  // one for each light, the same for those of a kind
  std::size_t sampled_ = 0;           // how many of them need more than one sample
};

}  // namespace capcon
