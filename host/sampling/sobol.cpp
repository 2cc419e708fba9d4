#include "layout.h"
#include "sampling/address.h"
#include "sampling/bits.h"
#include "sampling/samplers.h"

namespace capcon {
namespace {

/// The (0,2)-sequence. Its parts are blocks of successive points: nets themselves where their size is a power
/// of two.
class SobolSampler final : public Sampler {
 public:
  SobolSampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts, bool owen)
      : Sampler(owen ? "sobol-owen" : "sobol-xor", count, seed, parts), owen_(owen) {}

  FixedPoint point(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension,
                   SampleDomain) const override {
    const auto words = set_words(seed(), pixel, dimension);
    const std::uint32_t second = sobol_second_reversed(index);
    if (owen_) {
      return {reverse_bits(owen_scramble_reversed(index, words[0])),
              reverse_bits(owen_scramble_reversed(second, words[1]))};
    }
    return {reverse_bits(index) ^ words[0], reverse_bits(second) ^ words[1]};
  }

  SamplerTables tables(const std::vector<SampleDomain>&) const override {
    return {owen_ ? layout::kSamplerSobolOwen : layout::kSamplerSobolXor, {0, 0, 0, 0}, {}};
  }

 private:
  bool owen_;
};

}  // namespace

std::unique_ptr<Sampler> make_sobol_xor_sampler(std::uint32_t count, std::uint32_t seed,
                                                std::uint32_t parts) {
  return std::make_unique<SobolSampler>(count, seed, parts, false);
}

std::unique_ptr<Sampler> make_sobol_owen_sampler(std::uint32_t count, std::uint32_t seed,
                                                 std::uint32_t parts) {
  return std::make_unique<SobolSampler>(count, seed, parts, true);
}

}  // namespace capcon
