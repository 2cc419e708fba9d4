#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/error.h"
#include "base/morton.h"
#include "layout.h"
#include "sampling/address.h"
#include "sampling/bits.h"
#include "sampling/choice.h"
#include "sampling/domain_sampler.h"
#include "sampling/ensemble_store.h"
#include "sampling/samplers.h"

namespace capcon {
namespace {

std::uint32_t border(std::uint32_t i, std::uint32_t count) {
  return static_cast<std::uint32_t>((static_cast<std::uint64_t>(i) << 32) / count);
}

/// A single row or column is 2^32 - 1 wide: one value of 2^32 is never drawn.
std::uint32_t width(std::uint32_t i, std::uint32_t count) {
  return count == 1 ? 0xffffffffu : border(i + 1, count) - border(i, count);
}

void check_count(std::uint32_t count) {
  if (count > kMostEnsemblePoints) {
    throw InputError(
        fmt::format("the capcon-domain sampler makes sets of at most {} points, and {} are asked for; take "
                    "fewer samples, or sobol-owen",
                    kMostEnsemblePoints, count));
  }
  if (!can_make_ensemble(count)) {
    throw InputError(fmt::format(
        "the capcon-domain sampler has no grid for sets of {} points, a number with a large prime "
        "factor; take a multiple of 64 such as {}, or sobol-owen",
        count, (count + 63) / 64 * 64));
  }
}

struct MortonLess {
  std::uint32_t columns;
  bool operator()(std::uint32_t a, std::uint32_t b) const {
    return morton_code(a % columns, a / columns) < morton_code(b % columns, b / columns);
  }
};

/// Every `length` cells in Morton order.
void sort_each(Ensemble& e, std::ptrdiff_t length) {
  for (auto first = e.cells.begin(); first != e.cells.end(); first += length)
    std::sort(first, first + length, MortonLess{e.columns});
}

}  // namespace

EnsembleDomain ensemble_domain(SampleDomain domain) {
  return domain == SampleDomain::disk     ? EnsembleDomain::disk
         : domain == SampleDomain::square ? EnsembleDomain::square
                                          : EnsembleDomain::cylinder;
}

/// In Morton order lanes that run in step take neighbouring points; a flip keeps them neighbours.
Ensemble DomainSampler::ordered_sets(EnsembleDomain domain) const {
  Ensemble e = *made_once(std::pair(count(), domain), [&] { return stored_ensemble(count(), domain); });
  sort_each(e, count());
  return e;
}

DomainSampler::Sets DomainSampler::make_sets(EnsembleDomain domain) const {
  const Ensemble e = ordered_sets(domain);
  Sets result{e.sets, {}, {}};
  result.cells.reserve(e.cells.size());
  for (const std::uint32_t c : e.cells) {
    const std::uint32_t i = c % e.columns, j = c / e.columns;
    result.cells.push_back({border(i, e.columns), border(j, e.rows), width(i, e.columns), width(j, e.rows)});
  }
  if (dealt_parts() == 1) return result;
  Ensemble dealt = stored_parts(e, domain, dealt_parts());
  sort_each(dealt, split().points);
  for (std::size_t k = 0; k < dealt.cells.size(); ++k) {
    const auto first = e.cells.begin() + std::ptrdiff_t(k / count() * count());
    const auto found = std::lower_bound(first, first + count(), dealt.cells[k], MortonLess{e.columns});
    result.order.push_back(static_cast<std::uint32_t>(found - first));
  }
  return result;
}

FixedPoint DomainSampler::point(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension,
                                SampleDomain domain) const {
  const Sets& sets = sets_in(domain);
  const Choice choice = choose(pixel, dimension, domain, sets.sets);
  const std::size_t set = std::size_t(choice.set) * set_points();
  const std::uint32_t at = turned(pixel, index, dimension),
                      place = sets.order.empty() ? at : sets.order[set + at];
  const Cell& cell = sets.cells[set + place];
  // Where in its cell: an Owen-scrambled net over the set's order, so that neighbours' places in their
  // cells balance. Each is uniform, which is all that unbiasedness needs.
  const auto within = set_words(seed(), pixel, dimension, kPurposeWithin);
  const std::uint32_t near = near_place(place), u = reverse_bits(owen_scramble_reversed(near, within[2])),
                      v = reverse_bits(owen_scramble_reversed(sobol_second_reversed(near), within[3]));
  const FixedPoint p{cell.x + multiply_high(u, cell.width), cell.y + multiply_high(v, cell.height)};
  if (domain == SampleDomain::cylinder) return {p.x + choice.turn, (choice.flips & 1) != 0 ? ~p.y : p.y};
  // The square's eight symmetries, which the concentric map makes the disk's.
  FixedPoint q{choice.flips & 1 ? ~p.x : p.x, choice.flips & 2 ? ~p.y : p.y};
  if (choice.flips & 4) std::swap(q.x, q.y);
  return q;
}

/// Places are in Morton order, whose blocks are regions: those of two pairs are matched.
std::uint32_t DomainSampler::place_in_order(std::uint32_t index, std::uint32_t count, std::uint32_t,
                                            std::uint32_t dimension, std::uint32_t key) const {
  if (matched_regions(count) < 2) return permute(index, count, key);
  return matched_place(index, count, dimension == layout::kPairImage, key);
}

DomainSampler::Choice DomainSampler::choose(std::uint32_t pixel, std::uint32_t dimension, SampleDomain domain,
                                            std::uint32_t sets) const {
  const auto keys = set_words(seed(), pixel, dimension);
  // Not the first word, which is the hash's least mixed: with it a hundredth of the RMSE was bias
  // (tests/bench/sampling_bench.cpp).
  const std::uint32_t flips =
      domain == SampleDomain::cylinder ? set_words(seed(), pixel, dimension, kPurposeWithin)[1] : keys[1];
  return {multiply_high(keys[3], sets), flips & 7, keys[1]};
}

std::vector<SampleDomain> DomainSampler::in_table_order(const std::vector<SampleDomain>& domains) {
  std::vector<SampleDomain> result;
  for (const SampleDomain d : {SampleDomain::disk, SampleDomain::square, SampleDomain::cylinder})
    if (std::find(domains.begin(), domains.end(), d) != domains.end()) result.push_back(d);
  return result;
}

SamplerTables DomainSampler::tables(const std::vector<SampleDomain>& domains) const {
  SamplerTables result{layout::kSamplerCapconDomain, {0, 0, 0, dealt_parts()}, {}};
  for (const SampleDomain d : in_table_order(domains)) {
    const std::uint32_t sets = sets_in(d).sets;
    if (d == SampleDomain::disk) result.constants[0] = sets;
    if (d == SampleDomain::square) result.constants[1] = sets;
    if (d == SampleDomain::cylinder) result.constants[3] |= sets << 16;
    append(sets_in(d), result);
  }
  return result;
}

/// The cells, and with parts the order, four words a texel.
void DomainSampler::append(const Sets& sets, SamplerTables& result) {
  for (const Cell& c : sets.cells) result.texels.emplace_back(c.x, c.y, c.width, c.height);
  const auto word = [&](std::size_t i) { return i < sets.order.size() ? sets.order[i] : 0; };
  for (std::size_t i = 0; i < sets.order.size(); i += 4)
    result.texels.emplace_back(word(i), word(i + 1), word(i + 2), word(i + 3));
}

/// A part alone leaves out most cells of its set: which part comes first is random, so that each is unbiased.
std::uint32_t DomainSampler::turned(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension) const {
  if (dealt_parts() == 1) return index;
  const auto turn = set_words(seed(), pixel, dimension, kPurposeParts)[3];
  const std::uint32_t place = index + split().points * multiply_high(turn, split().parts);
  return place >= count() ? place - count() : place;
}

/// Made when points in that domain are first asked for.
const DomainSampler::Sets& DomainSampler::sets_in(SampleDomain domain) const {
  const auto d = static_cast<std::size_t>(domain);
  std::call_once(once_[d], [&] {
    const EnsembleDomain in = ensemble_domain(domain);
    sets_[d] = made_once(std::tuple(name(), set_points(), in, dealt_parts()), [&] { return make_sets(in); });
  });
  return *sets_[d];
}

std::unique_ptr<Sampler> make_capcon_domain_sampler(std::uint32_t count, std::uint32_t seed,
                                                    std::uint32_t parts) {
  check_count(count);
  return std::make_unique<DomainSampler>(count, seed, parts);
}

}  // namespace capcon
