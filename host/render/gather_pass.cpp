#include "render/gather_pass.h"

#include <algorithm>

namespace capcon {
namespace {

constexpr std::uint32_t kFewestColumns = 32, kMostColumns = 4096;  // virtual lights of a batch

/// Calls dispatch(push, groups) for the pieces of a batch, one for each pixel of a block: virtual lights
/// `first` ... `first` + `columns` - 1 of each set, as far as there are any.
template <class Dispatch>
void gather_batch(const GatherWork& work, const DeviceVirtualLights& lights, layout::GatherConstants push,
                  std::uint32_t first, std::uint32_t columns, const Dispatch& dispatch) {
  push.first_pixel = work.first_pixel;
  push.pixel_count = work.pixel_count;
  push.band = work.band;
  push.eye.w = work.limit;
  push.columns = columns;
  push.block = work.block;
  push.width = work.width;
  const std::uint32_t row = work.first_pixel / work.width;
  const std::uint32_t rows = (work.first_pixel + work.pixel_count - 1) / work.width - row + 1;
  for (std::uint32_t c = 0; c < work.block * work.block; ++c) {
    const std::uint32_t set = work.first_set + c;
    const std::uint32_t count = lights.count(set);
    push.first = lights.first[set] + std::min(first, count);
    push.count = std::min(columns, count - std::min(first, count));
    std::uint32_t pixels = work.pixel_count;
    push.across = 1;
    if (work.block > 1) {
      const std::uint32_t x = c % work.block, y = c / work.block;
      push.residue_x = x;
      push.row = row + (y + work.block - row % work.block) % work.block;
      push.across = x < work.width ? (work.width - x + work.block - 1) / work.block : 0;
      pixels = push.across * ((rows + work.block - 1) / work.block);
      if (pixels == 0) continue;
    }
    push.lanes = groups_for(pixels) * layout::kGroupSize;
    const std::uint32_t groups = push.lanes / layout::kGroupSize * columns;
    push.group_stride = spreading_stride(groups);
    dispatch(push, groups);
  }
}

}  // namespace

void GatherPass::gather(gpu::Kernel& kernel, gpu::Kernel& sum, GatherWork work, bool two_sided,
                        float weight) {
  const bool pixels = &sum == sum_;
  std::uint32_t most = 0;
  for (std::uint32_t c = 0; c < work.block * work.block; ++c)
    most = std::max(most, lights_.count(work.first_set + c));
  if (most == 0 || work.pixel_count == 0) return;
  const auto lanes = [&] { return static_cast<std::uint32_t>(batches_.lanes(kernel)); };
  layout::GatherConstants push{};
  push.tree = s_.tree;
  push.eye = with_word(s_.view.eye, 0u);
  push.two_sided = two_sided ? 1 : 0;
  const std::uint32_t all = work.pixel_count, end = work.first_pixel + all;
  for (; work.first_pixel < end; work.first_pixel += work.pixel_count) {
    const std::uint32_t columns =
        std::min({most, std::clamp(lanes() / all, kFewestColumns, kMostColumns), lanes()});
    work.pixel_count = std::min(lanes() / columns, end - work.first_pixel);
    for (std::uint32_t first = 0, count = 0; first < most; first += count) {
      count = std::min(most - first, std::clamp(lanes() / work.pixel_count, 1u, kMostColumns));
      gather_batch(work, lights_, push, first, count, [&](const auto& batch, std::uint32_t groups) {
        submit(kernel, &batch, groups, pixels ? "gather" : "compensation");
      });
      add_up(sum, work.first_pixel, work.pixel_count, count, work.band, weight);
      rays_ += std::uint64_t(work.pixel_count) * count;
      if (pixels) progress(static_cast<double>(work.pixel_count) * count, all_work_);
    }
  }
}

}  // namespace capcon
