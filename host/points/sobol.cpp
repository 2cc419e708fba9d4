#include "points/sobol.h"

#include "base/hash.h"

namespace capcon {

std::uint32_t sobol_x(std::uint32_t index) {
  std::uint32_t x = 0;
  for (int bit = 0; bit < 32; ++bit) x |= (index >> bit & 1) << (31 - bit);
  return x;
}

std::uint32_t sobol_y(std::uint32_t index) {
  // Each direction number is the one before, added without carry to itself shifted by one.
  std::uint32_t y = 0;
  for (std::uint32_t direction = 1u << 31; index != 0; index >>= 1, direction ^= direction >> 1) {
    if (index & 1) y ^= direction;
  }
  return y;
}

std::uint32_t owen_scrambled(std::uint32_t fraction, std::uint64_t seed, std::uint64_t stream) {
  std::uint32_t flips = 0;
  for (int bit = 31; bit >= 0; --bit) {
    // The leading 1 tells prefixes of different lengths apart.
    const std::uint64_t prefix = (1ull << (31 - bit)) | (static_cast<std::uint64_t>(fraction) >> bit >> 1);
    flips |= static_cast<std::uint32_t>(mix64(seed, stream, prefix) & 1) << bit;
  }
  return fraction ^ flips;
}

double radical_inverse(std::uint64_t index, std::uint32_t base) {
  std::uint64_t digits = 0, scale = 1;  // exact integers: rounded once
  for (; index > 0; index /= base, scale *= base) digits = digits * base + index % base;
  return static_cast<double>(digits) / static_cast<double>(scale);
}

}  // namespace capcon
