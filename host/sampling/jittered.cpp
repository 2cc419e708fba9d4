#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/hash.h"
#include "layout.h"
#include "sampling/address.h"
#include "sampling/bits.h"
#include "sampling/samplers.h"

namespace capcon {
namespace {

/// The largest divisor of n that is at most its root.
std::uint32_t rows_of(std::uint32_t n) {
  auto rows = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(n)));
  while (rows > 1 && n % rows != 0) --rows;
  return std::max(rows, 1u);
}

/// The columns of a block of `parts` strata: its rows are parts / columns, and both sides divide the grid's.
/// As square as it goes. There always is one: parts / gcd(parts, columns) divides the grid's rows.
std::uint32_t block_columns(std::uint32_t columns, std::uint32_t rows, std::uint32_t parts) {
  std::uint32_t best = std::gcd(parts, columns);
  double least = 1e300;
  for (std::uint32_t c = 1; c <= std::min(parts, columns); ++c) {
    if (parts % c != 0 || columns % c != 0 || rows % (parts / c) != 0) continue;
    const double shape = std::abs(std::log(double(c) * c * rows / (double(parts) * columns)));
    if (shape < least) least = shape, best = c;
  }
  return best;
}

/// (cell + word / 2^32) / cells as 0.32 fixed point, rounded down; exact in 64 bits.
std::uint32_t in_stratum(std::uint32_t cell, std::uint32_t cells, std::uint32_t word) {
  return static_cast<std::uint32_t>(((static_cast<std::uint64_t>(cell) << 32) + word) / cells);
}

class JitteredSampler final : public Sampler {
 public:
  JitteredSampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts)
      : Sampler("jittered", count, seed, parts),
        rows_(rows_of(count)),
        columns_(count / rows_),
        block_columns_(block_columns(columns_, rows_, parts)),
        block_rows_(parts / block_columns_) {}

  FixedPoint point(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension,
                   SampleDomain) const override {
    const auto words = pcg4d(pixel, index, dimension, seed());
    const auto [column, row] = stratum(pixel, index, dimension);
    return {in_stratum(column, columns_, words[0]), in_stratum(row, rows_, words[1])};
  }

  SamplerTables tables(const std::vector<SampleDomain>&) const override {
    // Rows are at most the count's root: 16 bits.
    const std::uint32_t block_rows = split().parts == 1 ? 0 : block_rows_;
    return {layout::kSamplerJittered, {columns_, rows_ | block_rows << 16, 0, split().parts}, {}};
  }

 protected:
  bool is_stored_by_place() const override { return true; }

 private:
  struct Stratum {
    std::uint32_t column, row;
  };

  /// Parts: the strata are grouped into blocks of as many as there are parts. Point i of every part lies in
  /// block i, in one stratum a part; which one, a hash of the block says, so that a part is a jittered set of
  /// its own.
  Stratum stratum(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension) const {
    const std::uint32_t parts = split().parts, across = columns_ / block_columns_;
    if (parts == 1) return {index % columns_, index / columns_};
    const std::uint32_t part = index / split().points, block = index % split().points;
    const auto turn = set_words(seed(), pixel, dimension, kPurposeParts + block)[3];
    const std::uint32_t place = (part + multiply_high(turn, parts)) % parts;
    return {block % across * block_columns_ + place % block_columns_,
            block / across * block_rows_ + place / block_columns_};
  }

  std::uint32_t rows_, columns_, block_columns_, block_rows_;
};

}  // namespace

std::unique_ptr<Sampler> make_jittered_sampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts) {
  return std::make_unique<JitteredSampler>(count, seed, parts);
}

}  // namespace capcon
