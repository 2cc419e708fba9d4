#include "tiling/gaussian_tiling.h"

#include <numeric>
#include <utility>

#include "base/error.h"

namespace capcon {
namespace {

std::int64_t wrap(std::int64_t value, std::int64_t period) {
  const std::int64_t rest = value % period;
  return rest < 0 ? rest + period : rest;
}

std::int64_t floor_div(std::int64_t value, std::int64_t divisor) {
  return (value - wrap(value, divisor)) / divisor;
}

// u with u b + v a = gcd(a, b) for some v.
std::int64_t bezout_of_b(std::int64_t a, std::int64_t b) {
  std::int64_t r0 = a, r1 = b, u0 = 0, u1 = 1;
  while (r1 != 0) {
    const std::int64_t q = r0 / r1;
    r0 = std::exchange(r1, r0 - q * r1);
    u0 = std::exchange(u1, u0 - q * u1);
  }
  return u0;
}

// numerator / denominator as 0.32 fixed point, rounded to nearest and wrapped to [0, 1). Both below 2^32.
std::uint32_t fixed_ratio(std::uint64_t numerator, std::uint64_t denominator) {
  return std::uint32_t(((numerator << 32) + denominator / 2) / denominator);
}

}  // namespace

GaussianTiling::GaussianTiling(std::uint32_t a, std::uint32_t b) : a_(a), b_(b) {
  if (a < 1 || b > a) throw InputError("a tiling needs a >= 1 and 0 <= b <= a");
  if (a > 0x7fff) throw InputError("a tiling has at most 32767 tiles along a side");
  size_ = std::uint32_t(a_ * a_ + b_ * b_);
  gcd_ = std::gcd(a, b);
  // Hermite normal form of the sublattice spanned by (a, b) and (-b, a): its vector of least height is
  // u (a, b) + v (-b, a) with u b + v a = gcd.
  const std::int64_t u = bezout_of_b(a_, b_);
  const std::int64_t v = (std::int64_t(gcd_) - u * b_) / a_;
  shift_ = wrap(u * a_ - v * b_, size_ / gcd_);
}

std::uint32_t GaussianTiling::index(std::int64_t x, std::int64_t y) const {
  const std::int64_t width = size_ / gcd_;
  const std::int64_t rows = floor_div(y, gcd_);
  return std::uint32_t((y - rows * gcd_) * width + wrap(x - wrap(rows, width) * shift_, width));
}

glm::ivec2 GaussianTiling::cell(std::uint32_t index) const {
  const std::uint32_t width = size_ / gcd_;
  return {int(index % width), int(index / width)};
}

std::array<std::uint32_t, 4> GaussianTiling::corners(std::uint32_t cell_index) const {
  const glm::ivec2 c = cell(cell_index);
  return {cell_index, index(c.x + 1, c.y), index(c.x, c.y + 1), index(c.x + 1, c.y + 1)};
}

// (x + iy) / (a + bi) = ((x a + y b) + i (y a - x b)) / N
FixedPoint GaussianTiling::origin(std::uint32_t cell_index) const {
  const glm::ivec2 c = cell(cell_index);
  return {fixed_ratio(std::uint64_t(wrap(c.x * a_ + c.y * b_, size_)), size_),
          fixed_ratio(std::uint64_t(wrap(c.y * a_ - c.x * b_, size_)), size_)};
}

FixedPoint GaussianTiling::place(FixedPoint p) const {
  const std::int64_t half = size_ / 2;
  const std::int64_t x = std::int64_t(p.x) * a_ + std::int64_t(p.y) * b_;
  const std::int64_t y = std::int64_t(p.y) * a_ - std::int64_t(p.x) * b_;
  return {std::uint32_t(floor_div(x + half, size_)), std::uint32_t(floor_div(y + half, size_))};
}

}  // namespace capcon
