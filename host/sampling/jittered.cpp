#include <cmath>

#include "base/hash.h"
#include "layout.h"
#include "sampling/samplers.h"

namespace capcon {
namespace {

/// The largest divisor of n that is at most its root.
std::uint32_t rows_of(std::uint32_t n) {
  auto rows = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(n)));
  while (rows > 1 && n % rows != 0) --rows;
  return std::max(rows, 1u);
}

/// (cell + word / 2^32) / cells as 0.32 fixed point, rounded down; exact in 64 bits.
std::uint32_t in_stratum(std::uint32_t cell, std::uint32_t cells, std::uint32_t word) {
  return static_cast<std::uint32_t>(((static_cast<std::uint64_t>(cell) << 32) + word) / cells);
}

class JitteredSampler final : public Sampler {
 public:
  JitteredSampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts)
      : Sampler("jittered", count, seed, parts), rows_(rows_of(count)), columns_(count / rows_) {}

  FixedPoint point(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension,
                   SampleDomain) const override {
    const auto words = pcg4d(pixel, index, dimension, seed());
    return {in_stratum(index % columns_, columns_, words[0]), in_stratum(index / columns_, rows_, words[1])};
  }

  SamplerTables tables(const std::vector<SampleDomain>&) const override {
    return {layout::kSamplerJittered, {columns_, rows_, 0, 0}, {}};
  }

 private:
  std::uint32_t rows_, columns_;
};

}  // namespace

std::unique_ptr<Sampler> make_jittered_sampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts) {
  return std::make_unique<JitteredSampler>(count, seed, parts);
}

}  // namespace capcon
