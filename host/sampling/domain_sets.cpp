#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <tuple>
#include <utility>

#include "base/error.h"
#include "base/morton.h"
#include "layout.h"
#include "points/halved_order.h"
#include "sampling/address.h"
#include "sampling/bits.h"
#include "sampling/choice.h"
#include "sampling/domain_sampler.h"
#include "sampling/ensemble_store.h"
#include "sampling/samplers.h"

namespace capcon {
namespace {

/// Of one of so many rows or columns. A single one is 2^32 - 1 wide: one value of 2^32 is never drawn.
std::uint32_t width(std::uint32_t count) {
  return count == 1 ? 0xffffffffu : static_cast<std::uint32_t>((std::uint64_t(1) << 32) / count);
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

/// Every `length` cells in an order whose blocks are regions.
void order_each(Ensemble& e, std::uint32_t length) {
  for (std::size_t k = 0; k < e.cells.size(); k += length) halve_in_turn(&e.cells[k], length, e.columns);
}

}  // namespace

EnsembleDomain ensemble_domain(SampleDomain domain) {
  return domain == SampleDomain::disk     ? EnsembleDomain::disk
         : domain == SampleDomain::square ? EnsembleDomain::square
                                          : EnsembleDomain::cylinder;
}

/// Lanes that run in step take points of one region; a flip keeps them together.
Ensemble DomainSampler::ordered_sets(EnsembleDomain domain) const {
  Ensemble e = *made_once(std::pair(count(), domain), [&] { return stored_ensemble(count(), domain); });
  order_each(e, count());
  return e;
}

DomainSampler::Sets DomainSampler::make_sets(EnsembleDomain domain) const {
  const Ensemble e = ordered_sets(domain);
  Sets result{e.sets, {}};
  result.cells.reserve(e.cells.size());
  for (std::uint32_t set = 0; set < e.sets; ++set) {
    // Where in its cell: a net, Owen-scrambled once a set, so that neighbours' places in their cells balance.
    const auto keys = set_words(0, set, static_cast<std::uint32_t>(domain), kPurposeWithin);
    const std::span cells(&e.cells[std::size_t(set) * set_points()], set_points());
    const std::vector<std::uint32_t> number = net_numbers(cells, e.columns);
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const std::uint32_t u = reverse_bits(owen_scramble_reversed(number[k], keys[2])),
                          v = reverse_bits(owen_scramble_reversed(sobol_second_reversed(number[k]), keys[3]));
      result.cells.push_back({cells[k] % e.columns | (cells[k] / e.columns) << 16,
                              u >> 16 | (v & 0xffff0000u), width(e.columns), width(e.rows)});
    }
  }
  if (dealt_parts() == 1) return result;
  // Part by part, each in an order of regions of its own; the net is the whole set's.
  Ensemble dealt = stored_parts(e, domain, dealt_parts());
  order_each(dealt, split().points);
  std::vector<Cell> by_number(e.cells.size());
  for (std::size_t k = 0; k < e.cells.size(); ++k) by_number[e.cells[k]] = result.cells[k];
  for (std::size_t k = 0; k < e.cells.size(); ++k) result.cells[k] = by_number[dealt.cells[k]];
  return result;
}

/// Places along a Morton curve: with those in the order of regions, errors of smooth integrands over the
/// square were 8 % larger at 256 points, others the same.
std::vector<std::uint32_t> DomainSampler::net_numbers(std::span<const std::uint32_t> cells,
                                                      std::uint32_t columns) const {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> along;
  for (std::uint32_t k = 0; k < cells.size(); ++k)
    along.emplace_back(morton_code(cells[k] % columns, cells[k] / columns), k);
  std::sort(along.begin(), along.end());
  std::vector<std::uint32_t> number(cells.size());
  for (std::uint32_t i = 0; i < along.size(); ++i) number[along[i].second] = i;
  return number;
}

FixedPoint DomainSampler::point(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension,
                                SampleDomain domain) const {
  const Sets& sets = sets_in(domain);
  const Choice choice = choose(pixel, dimension, domain, sets.sets);
  const Cell& cell = sets.cells[std::size_t(choice.set) * set_points() + turned(pixel, index, dimension)];
  // The net, shifted at random: each point is uniform in its cell, which is all that unbiasedness needs.
  const std::uint32_t u = (cell.within << 16) ^ choice.shift.x,
                      v = (cell.within & 0xffff0000u) ^ choice.shift.y;
  const FixedPoint p{(cell.at & 0xffff) * cell.width + multiply_high(u, cell.width),
                     (cell.at >> 16) * cell.height + multiply_high(v, cell.height)};
  if (domain == SampleDomain::cylinder) return {p.x + choice.turn, (choice.flips & 1) != 0 ? ~p.y : p.y};
  // The square's eight symmetries, which the concentric map makes the disk's.
  FixedPoint q{choice.flips & 1 ? ~p.x : p.x, choice.flips & 2 ? ~p.y : p.y};
  if (choice.flips & 4) std::swap(q.x, q.y);
  return q;
}

/// Blocks of places are regions: those of two pairs are matched.
std::uint32_t DomainSampler::place_in_order(std::uint32_t index, std::uint32_t count, std::uint32_t,
                                            std::uint32_t dimension, std::uint32_t key) const {
  if (matched_regions(count) < 2) return permute(index, count, key);
  return matched_place(index, count, dimension == layout::kPairImage, key);
}

DomainSampler::Choice DomainSampler::choose(std::uint32_t pixel, std::uint32_t dimension, SampleDomain domain,
                                            std::uint32_t sets) const {
  // Not the first word, which is the hash's least mixed: with it a hundredth of the RMSE was bias
  // (tests/bench/sampling_bench.cpp). One hash's time counts: the symmetry is a word's highest bits (the
  // lowest are those of other purposes' fourth word, too, of which capcon-ranked makes places), the first
  // shift its others; the set is another's highest bits, the second shift all of them, multiplied.
  const auto keys = set_words(seed(), pixel, dimension);
  const std::uint32_t set = multiply_high(keys[1], sets);
  if (domain != SampleDomain::cylinder)
    return {set, keys[3] >> 29, 0, {keys[3] << 3, keys[1] * kWithinFactor}};
  const auto within = set_words(seed(), pixel, dimension, kPurposeWithin);
  return {set, within[1] & 7, keys[3], {within[2], within[3]}};
}

std::vector<SampleDomain> DomainSampler::in_table_order(const std::vector<SampleDomain>& domains) {
  std::vector<SampleDomain> result;
  for (const SampleDomain d : {SampleDomain::disk, SampleDomain::square, SampleDomain::cylinder})
    if (std::find(domains.begin(), domains.end(), d) != domains.end()) result.push_back(d);
  return result;
}

SamplerTables DomainSampler::tables(const std::vector<SampleDomain>& domains) const {
  SamplerTables result{layout::kSamplerCapconDomain | (dealt_parts() > 1 ? layout::kSamplerInParts : 0),
                       {0, 0, 0, dealt_parts()},
                       {}};
  for (const SampleDomain d : in_table_order(domains)) {
    const std::uint32_t sets = sets_in(d).sets;
    if (d == SampleDomain::disk) result.constants[0] = sets;
    if (d == SampleDomain::square) result.constants[1] = sets;
    if (d == SampleDomain::cylinder) result.constants[3] |= sets << 16;
    append(sets_in(d), result);
  }
  return result;
}

/// Each set with room for a power of two.
void DomainSampler::append(const Sets& sets, SamplerTables& result) const {
  const std::size_t points = set_points(), room = std::bit_ceil(points);
  for (std::size_t set = 0; set < sets.sets; ++set) {
    for (std::size_t k = 0; k < room; ++k) {
      const Cell c = k < points ? sets.cells[set * points + k] : Cell{};
      result.texels.emplace_back(c.at, c.within, c.width, c.height);
    }
  }
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
