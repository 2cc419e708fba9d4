#pragma once

#include <array>
#include <cstdint>

#include "base/hash.h"

namespace capcon {

// The four words that every sampler draws from for a set, addressed by (seed, pixel, dimension, purpose). The
// shader side (shaders/sampling/hash.glsl) has the same purposes.
constexpr std::uint32_t kPurposeSet =
    0x80000000u;  ///< words x, y: the set's randomisation; z: its order; w: spare
constexpr std::uint32_t kPurposeColours = 0x90000000u;  ///< + group: 128 corner colours each
constexpr std::uint32_t kPurposeParts = 0xa0000000u;    ///< + block: word w turns the parts of a set
constexpr std::uint32_t kPurposeFiner = 0xc0000000u;    ///< + stratum: word y orders the parts within it
constexpr std::uint32_t kPurposeWithin = 0xb0000000u;   ///< words z, w: places within cells; y: a flip
constexpr std::uint32_t kPurposePaths = 0xd0000000u;    ///< + set: word y orders its light paths
constexpr std::uint32_t kPurposeScreen =
    0xe0000000u;  ///< of pixel 0: what a whole image has in common; x, y, z: shifts and keys, w: spare
constexpr std::uint32_t kWithinFactor = 0x9e3779b1u;  ///< makes of the word that chose a set a place in cells

inline std::array<std::uint32_t, 4> set_words(std::uint32_t seed, std::uint32_t pixel,
                                              std::uint32_t dimension, std::uint32_t purpose = kPurposeSet) {
  return pcg4d(pixel, purpose, dimension, seed);
}

}  // namespace capcon
