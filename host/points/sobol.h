#pragma once

#include <cstdint>

namespace capcon {

/// The first two Sobol' dimensions (a (0,2)-sequence in base 2) as 32-bit fractions. x is van der Corput's
/// sequence; y has the direction numbers of the primitive polynomial x + 1, that is Pascal's triangle
/// modulo 2.
std::uint32_t sobol_x(std::uint32_t index);
std::uint32_t sobol_y(std::uint32_t index);

/// Owen's nested uniform scrambling of a 32-bit fraction: bit b is flipped by a random bit that depends on
/// all bits above it (A. Owen, "Randomly permuted (t,m,s)-nets and (t,s)-sequences", 1995). One hash a bit:
/// exact, not fast.
std::uint32_t owen_scrambled(std::uint32_t fraction, std::uint64_t seed, std::uint64_t stream);

/// The radical inverse of the index in a base: its digits mirrored at the point.
double radical_inverse(std::uint64_t index, std::uint32_t base);

}  // namespace capcon
