#include "base/hash.h"
#include "layout.h"
#include "sampling/samplers.h"

namespace capcon {
namespace {

class RandomSampler final : public Sampler {
 public:
  RandomSampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts)
      : Sampler("random", count, seed, parts) {}

  FixedPoint point(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension,
                   SampleDomain) const override {
    const auto words = pcg4d(pixel, index, dimension, seed());
    return {words[0], words[1]};
  }

  SamplerTables tables(const std::vector<SampleDomain>&) const override {
    return {layout::kSamplerRandom, {}, {}};
  }
};

}  // namespace

std::unique_ptr<Sampler> make_random_sampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts) {
  return std::make_unique<RandomSampler>(count, seed, parts);
}

}  // namespace capcon
