#include "base/hash.h"
#include "layout.h"
#include "sampling/samplers.h"

namespace capcon {
namespace {

class RandomSampler final : public Sampler {
 public:
  RandomSampler(std::uint32_t count, std::uint32_t seed) : Sampler("random", count, seed) {}

  FixedPoint sample(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension) const override {
    const auto words = pcg4d(pixel, index, dimension, seed());
    return {words[0], words[1]};
  }

  SamplerTables tables(bool) const override { return {layout::kSamplerRandom, {}, {}}; }
};

}  // namespace

std::unique_ptr<Sampler> make_random_sampler(std::uint32_t count, std::uint32_t seed) {
  return std::make_unique<RandomSampler>(count, seed);
}

}  // namespace capcon
