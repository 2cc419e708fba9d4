#include "layout.h"
#include "sampling/address.h"
#include "sampling/bits.h"
#include "sampling/samplers.h"

namespace capcon {
namespace {

/// The (0,2)-sequence; its order is shuffled from the second dimension pair on, so that pairs are not correlated.
class SobolSampler final : public Sampler {
 public:
  SobolSampler(std::uint32_t count, std::uint32_t seed, bool owen)
      : Sampler(owen ? "sobol-owen" : "sobol-xor", count, seed), owen_(owen), stride_(coprime_stride(count)) {}

  FixedPoint sample(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension) const override {
    const auto words = set_words(seed(), pixel, dimension);
    if (dimension > 0) index = shuffle_index(index, count(), stride_, words[2]);
    const std::uint32_t second = sobol_second_reversed(index);
    if (owen_) {
      return {reverse_bits(owen_scramble_reversed(index, words[0])), reverse_bits(owen_scramble_reversed(second, words[1]))};
    }
    return {reverse_bits(index) ^ words[0], reverse_bits(second) ^ words[1]};
  }

  SamplerTables tables(bool) const override {
    return {owen_ ? layout::kSamplerSobolOwen : layout::kSamplerSobolXor, {0, 0, stride_, 0}, {}};
  }

 private:
  bool owen_;
  std::uint32_t stride_;
};

}  // namespace

std::unique_ptr<Sampler> make_sobol_xor_sampler(std::uint32_t count, std::uint32_t seed) {
  return std::make_unique<SobolSampler>(count, seed, false);
}

std::unique_ptr<Sampler> make_sobol_owen_sampler(std::uint32_t count, std::uint32_t seed) {
  return std::make_unique<SobolSampler>(count, seed, true);
}

}  // namespace capcon
