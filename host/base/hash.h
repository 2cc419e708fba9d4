#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace capcon {

/// Four well-mixed 32-bit words from four words of address (seed, pixel, sample, dimension): the pcg4d
/// function of Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020.
/// shaders/sampling/hash.glsl holds the same function; tests compare the bits.
std::array<std::uint32_t, 4> pcg4d(std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t w);

/// 64-bit mixing of a counter-based stream: the value number `counter` of stream (seed, stream). Any order of
/// calls gives the same values (two rounds of the splitmix64 finaliser, Steele et al. 2014).
std::uint64_t mix64(std::uint64_t seed, std::uint64_t stream, std::uint64_t counter);

/// mix64 as a double in [0, 1), 53 bits.
double uniform64(std::uint64_t seed, std::uint64_t stream, std::uint64_t counter);

/// FNV-1a, 64 bits: the checksum of our text formats.
std::uint64_t fnv1a64(std::string_view bytes);

}  // namespace capcon
