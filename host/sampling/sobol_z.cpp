#include <algorithm>
#include <bit>

#include "base/morton.h"
#include "layout.h"
#include "sampling/address.h"
#include "sampling/bits.h"
#include "sampling/samplers.h"

namespace capcon {
namespace {

/// Ahmed and Wonka, "Screen-Space Blue-Noise Diffusion of Monte Carlo Sampling Error via Hierarchical
/// Ordering of Pixels", 2020: one Owen-scrambled (0,2)-sequence a dimension pair for the whole image, whose
/// pixels follow each other along a Z curve. Every pixel takes 2^m successive points, a net, and so does
/// every block of 2 x 2, 4 x 4 ... pixels. The curve's order is scrambled as a binary tree (theirs: each four
/// by one of 24 permutations). Images of more points than indices have 32 bits for are cut into square tiles.
class SobolZSampler final : public Sampler {
 public:
  SobolZSampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts, std::uint32_t width)
      : Sampler("sobol-z", count, seed, parts),
        bits_(static_cast<std::uint32_t>(std::bit_width(count - 1))),
        digits_(std::min(15u, (32 - bits_) / 2)),
        width_(width) {}

  FixedPoint point(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension,
                   SampleDomain) const override {
    const std::uint32_t x = width_ > 0 ? pixel % width_ : pixel, y = width_ > 0 ? pixel / width_ : 0;
    const std::uint32_t mask = (1u << digits_) - 1;
    const auto keys = set_words(seed(), (x >> digits_) + ((y >> digits_) << 16), dimension, kPurposeScreen);
    const auto z = static_cast<std::uint32_t>(morton_code(x & mask, y & mask));
    const std::uint32_t place = z << bits_ | index;
    const std::uint32_t along = reverse_bits(owen_scramble_reversed(reverse_bits(place), keys[2]));
    return {reverse_bits(owen_scramble_reversed(along, keys[0])),
            reverse_bits(owen_scramble_reversed(sobol_second_reversed(along), keys[1]))};
  }

  SamplerTables tables(const std::vector<SampleDomain>&) const override {
    return {layout::kSamplerSobolZ, {bits_, digits_, 0, width_}, {}};
  }

 private:
  std::uint32_t bits_;    ///< of an index within a pixel
  std::uint32_t digits_;  ///< of a coordinate within a tile
  std::uint32_t width_;
};

}  // namespace

std::unique_ptr<Sampler> make_sobol_z_sampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts,
                                              std::uint32_t width) {
  return std::make_unique<SobolZSampler>(count, seed, parts, width);
}

}  // namespace capcon
