#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "render/batches.h"
#include "render/dispatch.h"
#include "render/renderer_state.h"
#include "scene/job.h"

namespace capcon {

/// What the integrators' jobs under way have in common: the rows asked for, cut into bands that the device
/// holds, primary rays, and the clock.
class Pass {
 protected:
  using Clock = std::chrono::steady_clock;

  /// Of an image with so many channels.
  Pass(RendererState& state, int first_row, int rows, int channels,
       const std::function<void(double)>& on_progress);

  /// Calls visit(first) for each band in turn, with band_ and band_pixels_ set; first: its first pixel of
  /// those asked for.
  template <class Visit>
  void each_band(const Visit& visit) {
    for (std::uint32_t done = 0; done < pixels_; done += band_pixels_) {
      band_ = first_ + done;
      band_pixels_ = static_cast<std::uint32_t>(std::min<std::size_t>(s_.band_pixels, pixels_ - done));
      visit(done);
    }
  }

  /// Calls visit(first, count) for pieces of the band's pixels of at most `most()`, or 1, asked for each.
  template <class Most, class Visit>
  void each_piece(const Most& most, const Visit& visit) {
    std::uint64_t count = 0;
    for (std::uint64_t first = 0; first < band_pixels_; first += count) {
      count = std::min<std::uint64_t>(std::max<std::uint64_t>(most(), 1), band_pixels_ - first);
      visit(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count));
    }
  }

  /// What the band's pixels see. `tables`: of the sampler that places image samples, its third word the
  /// stride of `count`.
  void primary(const gpu::Kernel& kernel, const SamplerTables& tables, bool jittered, std::uint32_t seed,
               std::uint32_t count, std::uint32_t sample_index);

  /// Runs a kernel and waits; its time counts for `stage`, and for the size of its batches. Then the caller
  /// is told how far the job is, who may throw.
  void submit(const gpu::Kernel& kernel, const void* push, std::uint32_t groups, const std::string& stage) {
    submit(kernel, push, groups, stage, std::uint64_t(groups) * layout::kGroupSize);
  }
  /// The same, of a kernel whose groups have other numbers of lanes: so many in all.
  void submit(const gpu::Kernel& kernel, const void* push, std::uint32_t groups, const std::string& stage,
              std::uint64_t lanes);

  /// A value of the image: the mean over a pixel's samples, `sum` over their number, and `more`. Of a share
  /// the sum stays one.
  void put(std::size_t value, double sum, double more, const SampleShare& share, std::uint32_t samples);

  /// Lanes done, of all.
  void progress(double lanes, double all);

  static glm::uvec4 words(const SamplerTables& t);
  static double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  RendererState& s_;
  const std::function<void(double)>& on_progress_;
  std::uint32_t first_ = 0, pixels_ = 0;      ///< of the rows asked for
  std::uint32_t band_ = 0, band_pixels_ = 0;  ///< of those on the device
  RenderResult result_;
  Batches batches_;

 private:
  double done_ = 0, fraction_ = 0;
};

/// Three numbers as floats and the bits of a word, for push constants.
glm::vec4 with_word(const glm::dvec3& v, std::uint32_t w);

}  // namespace capcon
