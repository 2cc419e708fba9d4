#include "points/pmj02.h"

#include <algorithm>

#include "layout.h"
#include "sampling/address.h"
#include "sampling/bits.h"
#include "sampling/samplers.h"

namespace capcon {
namespace {

// Sequences for pixels to choose from: more than enough for their number not to show in an image's error, and
// a table of half a megabyte at most for sets of up to 65,536 points.
constexpr std::uint32_t kMostSequences = 64;
constexpr std::uint32_t kTablePoints = 1u << 16;
// Of the sequences themselves, which are the same for every seed of a sampler.
constexpr std::uint64_t kTableSeed = 2018;

/// Stored sequences, one chosen for a (pixel, dimension pair) and digit-scrambled (XOR), which keeps nets
/// nets and makes every point uniform. Its parts are blocks of successive points: nets themselves where their
/// size is a power of two.
class Pmj02Sampler final : public Sampler {
 public:
  Pmj02Sampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts)
      : Sampler("pmj02", count, seed, parts),
        sequences_(std::clamp(kTablePoints / count, 1u, kMostSequences)) {
    points_.reserve(std::size_t(sequences_) * count);
    for (std::uint32_t s = 0; s < sequences_; ++s) {
      const auto sequence = pmj02_sequence(count, kTableSeed + s);
      points_.insert(points_.end(), sequence.begin(), sequence.end());
    }
  }

  FixedPoint point(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension,
                   SampleDomain) const override {
    const auto words = set_words(seed(), pixel, dimension);
    const glm::uvec2 p = points_[std::size_t(multiply_high(words[3], sequences_)) * count() + index];
    return {p.x ^ words[0], p.y ^ words[1]};
  }

  /// Two points a texel.
  SamplerTables tables(const std::vector<SampleDomain>&) const override {
    SamplerTables result{layout::kSamplerPmj02, {sequences_, 0, 0, 0}, {}};
    for (std::size_t i = 0; i < points_.size(); i += 2) {
      const glm::uvec2 a = points_[i], b = points_[std::min(i + 1, points_.size() - 1)];
      result.texels.emplace_back(a.x, a.y, b.x, b.y);
    }
    return result;
  }

 private:
  std::uint32_t sequences_;
  std::vector<glm::uvec2> points_;
};

}  // namespace

std::unique_ptr<Sampler> make_pmj02_sampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts) {
  return std::make_unique<Pmj02Sampler>(count, seed, parts);
}

}  // namespace capcon
