#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/hash.h"
#include "layout.h"
#include "points/ensemble.h"
#include "sampling/address.h"
#include "sampling/bits.h"
#include "sampling/disk_turn.h"
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
  std::vector<Cell> cells;
};

/// Bits of x at the even places, of y at the odd ones.
std::uint32_t interleave(std::uint32_t x, std::uint32_t y) {
  const auto spread = [](std::uint32_t v) {
    v = (v | v << 8) & 0x00ff00ffu;
    v = (v | v << 4) & 0x0f0f0f0fu;
    v = (v | v << 2) & 0x33333333u;
    return (v | v << 1) & 0x55555555u;
  };
  return spread(x) | spread(y) << 1;
}

Sets make_sets(std::uint32_t count, EnsembleDomain domain) {
  Ensemble e = make_ensemble({.points = count, .domain = domain});
  // In Morton order lanes that run in step take neighbouring points; a rotation or a flip keeps them
  // neighbours.
  for (std::uint32_t s = 0; s < e.sets; ++s) {
    const auto first = e.cells.begin() + std::ptrdiff_t(s) * count;
    std::sort(first, first + count, [&](std::uint32_t a, std::uint32_t b) {
      return interleave(a % e.columns, a / e.columns) < interleave(b % e.columns, b / e.columns);
    });
  }
  Sets result{e.sets, {}};
  result.cells.reserve(e.cells.size());
  for (const std::uint32_t c : e.cells) {
    const std::uint32_t i = c % e.columns, j = c / e.columns;
    result.cells.push_back({border(i, e.columns), border(j, e.rows), width(i, e.columns), width(j, e.rows)});
  }
  return result;
}

/// The same for all seeds, and a second's work for large sets: made once a program.
std::shared_ptr<const Sets> known_sets(std::uint32_t count, EnsembleDomain domain) {
  static std::mutex mutex;
  static std::map<std::pair<std::uint32_t, EnsembleDomain>, std::shared_ptr<const Sets>> known;
  const std::lock_guard lock(mutex);
  auto& sets = known[{count, domain}];
  if (!sets) sets = std::make_shared<const Sets>(make_sets(count, domain));
  return sets;
}

class DomainSampler final : public Sampler {
 public:
  DomainSampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts)
      : Sampler("capcon-domain", count, seed, parts) {}

  FixedPoint point(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension,
                   SampleDomain domain) const override {
    const auto keys = set_words(seed(), pixel, dimension);
    const bool disk = domain == SampleDomain::disk;
    const Sets& sets = sets_in(domain);
    const Cell& cell = sets.cells[std::size_t(multiply_high(keys[3], sets.sets)) * count() + index];
    const auto random = pcg4d(pixel, index, dimension, seed());
    const FixedPoint p{cell.x + multiply_high(random[0], cell.width),
                       cell.y + multiply_high(random[1], cell.height)};
    // Not the first word, which is the hash's least mixed: with it a hundredth of the RMSE was bias
    // (tests/bench/sampling_bench.cpp).
    if (disk) return turn_in_square(p, keys[1]);
    FixedPoint q{keys[1] & 1 ? ~p.x : p.x, keys[1] & 2 ? ~p.y : p.y};
    if (keys[1] & 4) std::swap(q.x, q.y);
    return q;
  }

  SamplerTables tables(const std::vector<SampleDomain>& domains) const override {
    SamplerTables result{layout::kSamplerCapconDomain, {}, {}};
    for (const SampleDomain d : {SampleDomain::disk, SampleDomain::square}) {
      if (std::find(domains.begin(), domains.end(), d) == domains.end()) continue;
      result.constants[d == SampleDomain::disk ? 0 : 1] = sets_in(d).sets;
      append(sets_in(d), result);
    }
    return result;
  }

 private:
  static void append(const Sets& sets, SamplerTables& result) {
    for (const Cell& c : sets.cells) result.texels.emplace_back(c.x, c.y, c.width, c.height);
  }
  /// Made when points in that domain are first asked for.
  const Sets& sets_in(SampleDomain domain) const {
    const auto d = static_cast<std::size_t>(domain);
    std::call_once(once_[d], [&] {
      sets_[d] =
          known_sets(count(), domain == SampleDomain::disk ? EnsembleDomain::disk : EnsembleDomain::square);
    });
    return *sets_[d];
  }

  mutable std::array<std::once_flag, 2> once_;
  mutable std::array<std::shared_ptr<const Sets>, 2> sets_;
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
  return std::make_unique<DomainSampler>(count, seed, parts);
}

}  // namespace capcon
