#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "points/ensemble.h"
#include "sampling/sampler.h"

namespace capcon {

EnsembleDomain ensemble_domain(SampleDomain domain);

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

/// Sets of an ensemble (points/ensemble.h) in the integral's own domain; which one, and turned how, hashes
/// say.
class DomainSampler : public Sampler {
 public:
  DomainSampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts)
      : DomainSampler("capcon-domain", count, seed, parts) {}
  FixedPoint point(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension,
                   SampleDomain domain) const override;
  SamplerTables tables(const std::vector<SampleDomain>& domains) const override;

 protected:
  DomainSampler(const char* name, std::uint32_t count, std::uint32_t seed, std::uint32_t parts)
      : Sampler(name, count, seed, parts) {}

  /// Which set, and turned how: bits of flips as ScreenMask::keys has them; the cylinder goes round by turn /
  /// 2^32; shift: of the points in their cells, a digital one.
  struct Choice {
    std::uint32_t set, flips, turn;
    FixedPoint shift;
  };
  std::uint32_t place_in_order(std::uint32_t index, std::uint32_t count, std::uint32_t stride,
                               std::uint32_t dimension, std::uint32_t key) const override;
  /// Of the sets' order: 1 where parts are single points, which any order has.
  virtual std::uint32_t dealt_parts() const { return split().points == 1 ? 1 : split().parts; }
  /// Of a set, of which count() are taken.
  virtual std::uint32_t set_points() const { return count(); }
  /// The sets, each with its cells in the order that places number.
  virtual Ensemble ordered_sets(EnsembleDomain domain) const;
  /// Which point of the net each of a set's cells has: near numbers for near cells.
  virtual std::vector<std::uint32_t> net_numbers(std::span<const std::uint32_t> cells,
                                                 std::uint32_t columns) const;
  /// The place in its set of the point at place `index` of the order.
  virtual std::uint32_t turned(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension) const;
  virtual Choice choose(std::uint32_t pixel, std::uint32_t dimension, SampleDomain domain,
                        std::uint32_t sets) const;
  /// Those asked for, in the order that their tables have.
  static std::vector<SampleDomain> in_table_order(const std::vector<SampleDomain>& domains);

 private:
  /// A cell of the grid: column | row << 16; where in it the set's net has its point, the upper 16 bits of x
  /// and y << 16; and in 0.32 fixed point the size of a column and of a row, which are all alike (rounded
  /// down: the last count / 2^32 of a side is never hit).
  struct Cell {
    std::uint32_t at = 0, within = 0, width = 0, height = 0;
  };
  struct Sets {
    std::uint32_t sets = 1;
    std::vector<Cell> cells;  ///< set by set, part by part
  };

  Sets make_sets(EnsembleDomain domain) const;
  void append(const Sets& sets, SamplerTables& result) const;
  const Sets& sets_in(SampleDomain domain) const;

  mutable std::array<std::once_flag, 3> once_;
  mutable std::array<std::shared_ptr<const Sets>, 3> sets_;
};

}  // namespace capcon
