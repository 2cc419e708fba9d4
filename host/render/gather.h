#pragma once

#include "render/light_paths.h"
#include "render/pass.h"

namespace capcon {

/// Rays from surfaces to virtual lights.
struct GatherWork {
  std::uint32_t first_pixel = 0, pixel_count = 0;  ///< pixels, or receivers
  std::uint32_t band = 0;
  std::uint32_t first_set = 0;  ///< of the pixel at block (0, 0); the others' follow
  std::uint32_t block = 1, width = 1;
  float limit = 3e38f;
};

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

}  // namespace capcon
