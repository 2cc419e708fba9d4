#include "points/halton.h"

#include <cassert>

#include "base/hash.h"

namespace capcon {

double owen_radical_inverse(std::uint64_t index, std::uint32_t base, std::uint64_t seed,
                            std::uint64_t stream) {
  assert(base == 2 || base == 3);
  static constexpr std::uint8_t kPermutations[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                                       {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  const int digits = base == 2 ? 53 : 33;  // base^digits <= 2^53: exact in a double
  std::uint64_t before = 1;                // the digits before, behind a 1 that tells their number
  std::uint64_t numerator = 0, denominator = 1;
  for (int k = 0; k < digits; ++k) {
    const std::uint64_t digit = index % base, random = mix64(seed, stream, before);
    index /= base;
    before = before * base + digit;
    numerator = numerator * base + (base == 2 ? digit ^ (random & 1) : kPermutations[random % 6][digit]);
    denominator *= base;
  }
  return static_cast<double>(numerator) / static_cast<double>(denominator);
}

}  // namespace capcon
