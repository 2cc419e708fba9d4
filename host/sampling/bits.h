#pragma once

#include <cstdint>

namespace capcon {

/// floor(a * b / 2^32)
constexpr std::uint32_t multiply_high(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::uint32_t>((static_cast<std::uint64_t>(a) * b) >> 32);
}

/// The 32 bits in opposite order.
constexpr std::uint32_t reverse_bits(std::uint32_t v) {
  v = (v >> 16) | (v << 16);
  v = ((v & 0xff00ff00u) >> 8) | ((v & 0x00ff00ffu) << 8);
  v = ((v & 0xf0f0f0f0u) >> 4) | ((v & 0x0f0f0f0fu) << 4);
  v = ((v & 0xccccccccu) >> 2) | ((v & 0x33333333u) << 2);
  return ((v & 0xaaaaaaaau) >> 1) | ((v & 0x55555555u) << 1);
}

/// The second Sobol' dimension of `index`, bits reversed (lowest bit first). Its generator matrix is Pascal's
/// triangle modulo 2: bit j is the sum of the index' bits k with j a subset of k, which five folding steps
/// compute.
constexpr std::uint32_t sobol_second_reversed(std::uint32_t index) {
  index ^= (index >> 1) & 0x55555555u;
  index ^= (index >> 2) & 0x33333333u;
  index ^= (index >> 4) & 0x0f0f0f0fu;
  index ^= (index >> 8) & 0x00ff00ffu;
  return index ^ ((index >> 16) & 0x0000ffffu);
}

/// Owen (nested uniform) scrambling of a word given lowest bit first: a bit is flipped by a hash of the bits
/// below it. Laine and Karras 2011 in the form of Burley, JCGT 9(4), 2020; constants by N. Vegdahl, 2021.
constexpr std::uint32_t owen_scramble_reversed(std::uint32_t v, std::uint32_t key) {
  v ^= v * 0x3d20adeau;
  v += key;
  v *= (key >> 16) | 1u;
  v ^= v * 0x05526c56u;
  v ^= v * 0x53a22864u;
  return v;
}

/// A permutation of [0, count) keyed by `key`: aligned blocks of powers of two stay together (nested uniform)
/// where count is a power of two; else a rotation of a golden-ratio stride, `stride` coprime to count.
constexpr std::uint32_t shuffle_index(std::uint32_t index, std::uint32_t count, std::uint32_t stride,
                                      std::uint32_t key) {
  if ((count & (count - 1)) == 0) {
    return reverse_bits(owen_scramble_reversed(reverse_bits(index), key)) & (count - 1);
  }
  return static_cast<std::uint32_t>((static_cast<std::uint64_t>(index) * stride + key % count) % count);
}

/// shuffle_index of the parts, and within each part with a key of its own.
template <class Split>
constexpr std::uint32_t shuffle_split(std::uint32_t index, const Split& split, std::uint32_t key) {
  const std::uint32_t part = index / split.points;
  return shuffle_index(part, split.parts, split.part_stride, key) * split.points +
         shuffle_index(index % split.points, split.points, split.point_stride, key + part * 0x9e3779b9u);
}

/// A stride for shuffle_index: coprime to count, near count / golden ratio.
std::uint32_t coprime_stride(std::uint32_t count);

}  // namespace capcon
