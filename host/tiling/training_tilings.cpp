#include "tiling/training_tilings.h"

#include <algorithm>

#include "base/hash.h"

namespace capcon {
namespace {

constexpr std::uint32_t kTrainingSide = 8;
constexpr std::uint64_t kTrainingStream = 0x747261696e;

// Tilings of few tiles are what renderers use most: their share of the training weight.
struct SmallTilings {
  std::uint32_t a, b, count;
  double share;
};
constexpr SmallTilings kSmall[] = {{1, 0, 8, 0.06}, {1, 1, 16, 0.03}, {2, 0, 32, 0.03}, {2, 2, 16, 0.03}};

std::uint64_t colouring_count(std::uint32_t colours, std::uint32_t vertices) {
  std::uint64_t count = 1;
  for (std::uint32_t v = 0; v < vertices && count < 1000; ++v) count *= colours;
  return count;
}

// Few colourings of few tiles, and more weight for these: all tiles of the smallest sets are in a corner.
constexpr SmallTilings kSmallBounded[] = {{2, 0, 2, 0.15}, {3, 0, 16, 0.15}, {4, 0, 12, 0.15}};

void add_small_bounded(const TrainingSet& set, std::uint32_t count, std::vector<TrainingTiling>& result) {
  for (const SmallTilings& small : kSmallBounded) {
    const GaussianTiling tiling(small.a, small.b);
    const double weight =
        small.share * count * kTrainingSide * kTrainingSide / double(small.count * tiling.size());
    for (std::uint32_t i = 0; i < small.count; ++i) {
      const std::uint64_t stream = kTrainingStream + 1 + tiling.size();
      auto colours = random_colours(tiling, set.colours, set.colouring, mix64(set.seed, stream, i));
      if (tiling.size() == 4) colours[3] = i % (set.colours - 1);  // the one vertex inside
      result.push_back({tiling, std::move(colours), weight});
    }
  }
}

}  // namespace

std::vector<TrainingTiling> training_tilings(const TrainingSet& set, std::uint32_t count) {
  std::vector<TrainingTiling> result;
  const GaussianTiling square(kTrainingSide, 0);
  for (std::uint32_t i = 0; i < count; ++i)
    result.push_back(
        {square, random_colours(square, set.colours, set.colouring, mix64(set.seed, kTrainingStream, i)), 1});
  if (set.colouring == Colouring::bounded) {
    add_small_bounded(set, count, result);
    return result;
  }
  for (const SmallTilings& small : kSmall) {
    const GaussianTiling tiling(small.a, small.b);
    const std::uint64_t stream = kTrainingStream + 1 + tiling.size();
    // Every colouring if they are few and all allowed, else random ones.
    const std::uint64_t all = colouring_count(set.colours, tiling.size());
    const std::uint64_t used = std::min<std::uint64_t>(all, small.count);
    const double weight = small.share * count * square.size() / double(used * tiling.size());
    for (std::uint64_t i = 0; i < used; ++i) {
      if (set.colouring != Colouring::free) {
        result.push_back(
            {tiling, random_colours(tiling, set.colours, set.colouring, mix64(set.seed, stream, i)), weight});
        continue;
      }
      std::uint64_t code = all <= small.count ? i : mix64(set.seed, stream, i);
      std::vector<std::uint32_t> colours(tiling.size());
      for (std::uint32_t& c : colours) c = std::uint32_t(code % set.colours), code /= set.colours;
      result.push_back({tiling, std::move(colours), weight});
    }
  }
  return result;
}

}  // namespace capcon
