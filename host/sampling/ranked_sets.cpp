#include <fmt/format.h>

#include "base/error.h"
#include "layout.h"
#include "sampling/address.h"
#include "sampling/bits.h"
#include "sampling/domain_sampler.h"
#include "sampling/ensemble_store.h"
#include "sampling/samplers.h"

namespace capcon {
namespace {

/// The first points of ranked sets of 256 or 1,024 (points/ranked_order.h): points that more can follow.
class RankedSampler final : public DomainSampler {
 public:
  RankedSampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts)
      : DomainSampler("capcon-ranked", count, seed, parts) {}

  SamplerTables tables(const std::vector<SampleDomain>& domains) const override {
    SamplerTables result = DomainSampler::tables(domains);
    result.id = layout::kSamplerCapconRanked;
    return result;
  }

 protected:
  std::uint32_t set_points() const override { return ranked_set_points(count()); }
  Ensemble ordered_sets(EnsembleDomain domain) const override {
    return stored_ranked_sets(set_points(), domain);
  }
  std::vector<std::uint32_t> net_numbers(std::span<const std::uint32_t> cells, std::uint32_t) const override {
    std::vector<std::uint32_t> number(cells.size());
    for (std::uint32_t k = 0; k < cells.size(); ++k) number[k] = place_of_rank(k, set_points());
    return number;
  }
  /// Parts are points that follow each other, as of any sequence.
  std::uint32_t dealt_parts() const override { return 1; }
  /// A random digital shift of the ranks: blocks stay blocks, and every sample any of the set's points.
  std::uint32_t turned(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension) const override {
    return index ^ (set_words(seed(), pixel, dimension, kPurposeParts)[3] & (set_points() - 1));
  }
  /// Ranks c q + t are of region t and class c: of each class every pair has the regions in an order of its
  /// own (matched_rank).
  std::uint32_t place_in_order(std::uint32_t index, std::uint32_t, std::uint32_t, std::uint32_t dimension,
                               std::uint32_t) const override {
    return matched_rank(index, set_points(), dimension == layout::kPairImage);
  }
};

}  // namespace

std::unique_ptr<Sampler> make_capcon_ranked_sampler(std::uint32_t count, std::uint32_t seed,
                                                    std::uint32_t parts) {
  if (count > 1024) {
    throw InputError(
        fmt::format("the capcon-ranked sampler takes points of sets of 1024, and {} are asked for; take "
                    "capcon-domain or sobol-owen",
                    count));
  }
  return std::make_unique<RankedSampler>(count, seed, parts);
}

}  // namespace capcon
