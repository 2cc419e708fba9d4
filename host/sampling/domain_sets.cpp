#include <fmt/format.h>

#include <algorithm>
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
  DomainSampler(std::uint32_t count, std::uint32_t seed)
      : Sampler("capcon-domain", count, seed),
        disk_(known_sets(count, EnsembleDomain::disk)),
        stride_(coprime_stride(count)) {}

  FixedPoint sample(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension) const override {
    const auto keys = set_words(seed(), pixel, dimension);
    const bool disk = dimension == 0;
    if (!disk) index = shuffle_index(index, count(), stride_, keys[2]);
    const Sets& sets = disk ? *disk_ : square();
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

  SamplerTables tables(bool first_only) const override {
    SamplerTables result{layout::kSamplerCapconDomain, {disk_->sets, 0, stride_, 0}, {}};
    append(*disk_, result);
    if (first_only) return result;
    result.constants[1] = square().sets;
    append(square(), result);
    return result;
  }

 private:
  static void append(const Sets& sets, SamplerTables& result) {
    for (const Cell& c : sets.cells) result.texels.emplace_back(c.x, c.y, c.width, c.height);
  }
  /// Made when a dimension pair beyond the first is asked for.
  const Sets& square() const {
    std::call_once(square_once_, [&] { square_ = known_sets(count(), EnsembleDomain::square); });
    return *square_;
  }

  std::shared_ptr<const Sets> disk_;
  mutable std::once_flag square_once_;
  mutable std::shared_ptr<const Sets> square_;
  std::uint32_t stride_;
};

}  // namespace

std::unique_ptr<Sampler> make_capcon_domain_sampler(std::uint32_t count, std::uint32_t seed) {
  if (count > kMostEnsemblePoints) {
    throw InputError(
        fmt::format("the capcon-domain sampler makes sets of at most {} points, and {} are asked for; take "
                    "fewer samples, or sobol-owen",
                    kMostEnsemblePoints, count));
  }
  return std::make_unique<DomainSampler>(count, seed);
}

}  // namespace capcon
