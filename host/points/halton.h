#pragma once

#include <cstdint>

namespace capcon {

/// The radical inverse of the index in base 2 or 3 with Owen's nested uniform scrambling (A. Owen, "Randomly
/// permuted (t,m,s)-nets and (t,s)-sequences", 1995): each digit goes through a random permutation of its own
/// for every string of digits before it, 53 digits in base 2 and 33 in base 3. As evenly spread as the plain
/// one, and uniform: each value on its own is a uniform random number.
double owen_radical_inverse(std::uint64_t index, std::uint32_t base, std::uint64_t seed,
                            std::uint64_t stream);

}  // namespace capcon
