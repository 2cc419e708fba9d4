#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/hash.h"
#include "base/morton.h"
#include "layout.h"
#include "points/ensemble.h"
#include "sampling/address.h"
#include "sampling/bits.h"
#include "sampling/disk_turn.h"
#include "sampling/ensemble_store.h"
#include "sampling/samplers.h"

namespace capcon {
namespace {

/// A cell in 0.32 fixed point: its low corner and its size.
struct Cell {
  std::uint32_t x, y, width, height;
};

std::uint32_t border(std::uint32_t i, std::uint32_t count) {
  return static_cast<std::uint32_t>((static_cast<std::uint64_t>(i) << 32) / count);
}

/// A single row or column is 2^32 - 1 wide: one value of 2^32 is never drawn.
std::uint32_t width(std::uint32_t i, std::uint32_t count) {
  return count == 1 ? 0xffffffffu : border(i + 1, count) - border(i, count);
}

struct Sets {
  std::uint32_t sets = 1;
  std::vector<Cell> cells;           ///< set by set, each in Morton order
  std::vector<std::uint32_t> order;  ///< with parts: [set * count + index]: place in the set, part by part
};

/// The same for all seeds, and a second's work for large sets: made once a program.
template <class Key, class Make>
auto made_once(const Key& key, Make make) {
  using Made = decltype(make());
  static std::mutex mutex;
  static std::map<Key, std::shared_ptr<const Made>> known;
  const std::lock_guard lock(mutex);
  auto& made = known[key];
  if (!made) made = std::make_shared<const Made>(make());
  return made;
}

Sets make_sets(std::uint32_t count, EnsembleDomain domain, std::uint32_t parts) {
  Ensemble e = *made_once(std::pair(count, domain), [&] { return stored_ensemble(count, domain); });
  // In Morton order lanes that run in step take neighbouring points; a rotation or a flip keeps them
  // neighbours.
  const auto less = [&](std::uint32_t a, std::uint32_t b) {
    return morton_code(a % e.columns, a / e.columns) < morton_code(b % e.columns, b / e.columns);
  };
  const auto sort_each = [&](std::vector<std::uint32_t>& cells, std::ptrdiff_t length) {
    for (auto first = cells.begin(); first != cells.end(); first += length)
      std::sort(first, first + length, less);
  };
  sort_each(e.cells, count);
  Sets result{e.sets, {}, {}};
  result.cells.reserve(e.cells.size());
  for (const std::uint32_t c : e.cells) {
    const std::uint32_t i = c % e.columns, j = c / e.columns;
    result.cells.push_back({border(i, e.columns), border(j, e.rows), width(i, e.columns), width(j, e.rows)});
  }
  if (parts == 1) return result;
  Ensemble dealt = stored_parts(e, domain, parts);
  sort_each(dealt.cells, count / parts);
  for (std::size_t k = 0; k < dealt.cells.size(); ++k) {
    const auto first = e.cells.begin() + std::ptrdiff_t(k / count * count);
    const auto found = std::lower_bound(first, first + count, dealt.cells[k], less);
    result.order.push_back(static_cast<std::uint32_t>(found - first));
  }
  return result;
}

class DomainSampler final : public Sampler {
 public:
  DomainSampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts)
      : Sampler("capcon-domain", count, seed, parts) {}

  FixedPoint point(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension,
                   SampleDomain domain) const override {
    const auto keys = set_words(seed(), pixel, dimension);
    const Sets& sets = sets_in(domain);
    const std::size_t set = std::size_t(multiply_high(keys[3], sets.sets)) * count();
    const std::uint32_t place =
        sets.order.empty() ? index : sets.order[set + turned(pixel, index, dimension)];
    const Cell& cell = sets.cells[set + place];
    // Where in its cell: an Owen-scrambled net over the set's order, so that neighbours' places in their
    // cells balance. Each is uniform, which is all that unbiasedness needs.
    const auto within = set_words(seed(), pixel, dimension, kPurposeWithin);
    const std::uint32_t u = reverse_bits(owen_scramble_reversed(place, within[2])),
                        v = reverse_bits(owen_scramble_reversed(sobol_second_reversed(place), within[3]));
    const FixedPoint p{cell.x + multiply_high(u, cell.width), cell.y + multiply_high(v, cell.height)};
    // Not the first word, which is the hash's least mixed: with it a hundredth of the RMSE was bias
    // (tests/bench/sampling_bench.cpp).
    if (domain == SampleDomain::disk) return turn_in_square(p, keys[1]);
    if (domain == SampleDomain::cylinder) return {p.x + keys[1], (within[1] & 1) != 0 ? ~p.y : p.y};
    FixedPoint q{keys[1] & 1 ? ~p.x : p.x, keys[1] & 2 ? ~p.y : p.y};
    if (keys[1] & 4) std::swap(q.x, q.y);
    return q;
  }

  SamplerTables tables(const std::vector<SampleDomain>& domains) const override {
    SamplerTables result{layout::kSamplerCapconDomain, {0, 0, 0, split().parts}, {}};
    for (const SampleDomain d : {SampleDomain::disk, SampleDomain::square, SampleDomain::cylinder}) {
      if (std::find(domains.begin(), domains.end(), d) == domains.end()) continue;
      const std::uint32_t sets = sets_in(d).sets;
      if (d == SampleDomain::disk) result.constants[0] = sets;
      if (d == SampleDomain::square) result.constants[1] = sets;
      if (d == SampleDomain::cylinder) result.constants[3] |= sets << 16;
      append(sets_in(d), result);
    }
    return result;
  }

 private:
  /// The cells, and with parts the order, four words a texel.
  static void append(const Sets& sets, SamplerTables& result) {
    for (const Cell& c : sets.cells) result.texels.emplace_back(c.x, c.y, c.width, c.height);
    const auto word = [&](std::size_t i) { return i < sets.order.size() ? sets.order[i] : 0; };
    for (std::size_t i = 0; i < sets.order.size(); i += 4)
      result.texels.emplace_back(word(i), word(i + 1), word(i + 2), word(i + 3));
  }

  /// A part alone leaves out most cells of its set: which part comes first is random, so that each is
  /// unbiased.
  std::uint32_t turned(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension) const {
    const auto turn = set_words(seed(), pixel, dimension, kPurposeParts)[3];
    const std::uint32_t place = index + split().points * multiply_high(turn, split().parts);
    return place >= count() ? place - count() : place;
  }

  /// Made when points in that domain are first asked for.
  const Sets& sets_in(SampleDomain domain) const {
    const auto d = static_cast<std::size_t>(domain);
    std::call_once(once_[d], [&] {
      const EnsembleDomain in = domain == SampleDomain::disk     ? EnsembleDomain::disk
                                : domain == SampleDomain::square ? EnsembleDomain::square
                                                                 : EnsembleDomain::cylinder;
      sets_[d] = made_once(std::tuple(count(), in, split().parts),
                           [&] { return make_sets(count(), in, split().parts); });
    });
    return *sets_[d];
  }

  mutable std::array<std::once_flag, 3> once_;
  mutable std::array<std::shared_ptr<const Sets>, 3> sets_;
};

}  // namespace

std::unique_ptr<Sampler> make_capcon_domain_sampler(std::uint32_t count, std::uint32_t seed,
                                                    std::uint32_t parts) {
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
  return std::make_unique<DomainSampler>(count, seed, parts);
}

}  // namespace capcon
