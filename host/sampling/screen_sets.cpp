#include <fmt/format.h>

#include "base/error.h"
#include "layout.h"
#include "points/screen_mask.h"
#include "sampling/address.h"
#include "sampling/domain_sampler.h"
#include "sampling/ensemble_store.h"
#include "sampling/samplers.h"

namespace capcon {
namespace {

/// The same sets, dealt to the pixels of an image so that what neighbours err cancels.
class ScreenSampler final : public DomainSampler {
 public:
  ScreenSampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts, std::uint32_t width)
      : DomainSampler("capcon-screen", count, seed, parts), width_(width) {}

  /// After the cells the masks, eight keys a texel.
  SamplerTables tables(const std::vector<SampleDomain>& domains) const override {
    SamplerTables result = DomainSampler::tables(domains);
    result.id = layout::kSamplerCapconScreen | (result.id & layout::kSamplerInParts);
    result.constants[2] = dealt_parts() << 16;  // where the third word is a stride, there are no parts
    result.constants[3] = (result.constants[3] & 0xffff0000u) | (width_ & 0xffffu);
    for (const SampleDomain d : in_table_order(domains)) {
      const auto& keys = mask_in(d).keys;
      const auto two = [&](std::size_t k) {
        return std::uint32_t(keys[k]) | std::uint32_t(keys[k + 1]) << 16;
      };
      for (std::size_t k = 0; k < keys.size(); k += 8)
        result.texels.emplace_back(two(k), two(k + 2), two(k + 4), two(k + 6));
    }
    return result;
  }

 protected:
  Choice choose(std::uint32_t pixel, std::uint32_t dimension, SampleDomain domain,
                std::uint32_t sets) const override {
    const ScreenMask& mask = mask_in(domain);
    // The whole image's mask is shifted at random, in every pair elsewhere.
    const auto image = set_words(seed(), 0, dimension, kPurposeScreen);
    const std::uint32_t x = width_ > 0 ? pixel % width_ : pixel, y = width_ > 0 ? pixel / width_ : 0;
    const std::uint32_t key = mask.keys[((x + image[1]) & (ScreenMask::kColumns - 1)) +
                                        ScreenMask::kColumns * ((y + (image[2] >> 16)) % mask.rows)];
    return {key >> 3, key & 7, (key >> 1 & 3) * 0x40000000u + image[3],
            DomainSampler::choose(pixel, dimension, domain, sets).shift};
  }

 private:
  const ScreenMask& mask_in(SampleDomain domain) const {
    const auto d = static_cast<std::size_t>(domain);
    std::call_once(once_[d], [&] {
      masks_[d] = made_once(std::pair(count(), domain),
                            [&] { return stored_screen_mask(count(), ensemble_domain(domain)); });
    });
    return *masks_[d];
  }

  std::uint32_t width_;
  mutable std::array<std::once_flag, 3> once_;
  mutable std::array<std::shared_ptr<const ScreenMask>, 3> masks_;
};

}  // namespace

std::unique_ptr<Sampler> make_capcon_screen_sampler(std::uint32_t count, std::uint32_t seed,
                                                    std::uint32_t parts, std::uint32_t width) {
  if (count > kMostScreenPoints) {
    throw InputError(
        fmt::format("the capcon-screen sampler has sets of at most {} points, and {} are asked for; take "
                    "capcon-domain",
                    kMostScreenPoints, count));
  }
  return std::make_unique<ScreenSampler>(count, seed, parts, width);
}

}  // namespace capcon
