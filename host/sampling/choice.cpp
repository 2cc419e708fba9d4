#include "sampling/choice.h"

#include <bit>

#include "layout.h"
#include "sampling/address.h"

namespace capcon {

std::uint32_t permute(std::uint32_t index, std::uint32_t count, std::uint32_t key) {
  if (count <= 1) return 0;
  const std::uint32_t bits = 32 - static_cast<std::uint32_t>(std::countl_zero(count - 1));
  const std::uint32_t mask = bits == 32 ? 0xffffffffu : (1u << bits) - 1;
  const std::uint32_t shift = (bits + 1) / 2;
  std::uint32_t x = index;
  do {
    std::uint32_t k = key;
    for (int round = 0; round < 8; ++round) {
      k = k * 747796405u + 2891336453u;  // a linear congruential generator's step (O'Neill 2014)
      x = (x * ((k >> 15) | 1u) + (k >> 9)) & mask;
      x ^= x >> shift;
    }
  } while (x >= count);
  return x;
}

std::uint32_t path_point(std::uint32_t seed, std::uint32_t set, std::uint32_t path, std::uint32_t paths,
                         std::uint32_t bounce, std::uint32_t pair) {
  return permute(path, paths, set_words(seed, bounce, pair, kPurposePaths + set)[1]);
}

std::uint32_t component_choice(std::uint32_t seed, std::uint32_t pixel, std::uint32_t part,
                               std::uint32_t index, const Split& split, bool separate) {
  const std::uint32_t number = layout::kPairComponent + (part << 16);
  const auto words = set_words(seed, pixel, number);
  std::uint32_t cell = permute(index, split.points, words[1]);
  std::uint32_t cells = split.points;
  if (!separate && split.parts > 1) {
    // In each stratum of a part the parts take finer strata, each its own.
    const auto finer = set_words(seed, pixel, layout::kPairComponent, kPurposeFiner + cell);
    cell = cell * split.parts + permute(part, split.parts, finer[1]);
    cells *= split.parts;
  }
  const std::uint32_t width = 0xffffffffu / cells;
  const std::uint32_t random = pcg4d(pixel, index, number, seed)[2];
  return cell * width + static_cast<std::uint32_t>((static_cast<std::uint64_t>(random) * width) >> 32);
}

}  // namespace capcon
