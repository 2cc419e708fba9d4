#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "points/ranked_order.h"

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

/// The regions that a set of `count` points is cut into so that pairs of dimensions can be matched: the
/// largest power of two q with q^2 <= count that divides count.
constexpr std::uint32_t matched_regions(std::uint32_t count) {
  const std::uint32_t root = 1u << ((31 - std::countl_zero(count)) / 2);
  return std::min(root, count & (0 - count));
}

/// c x in the field of q elements, a power of two up to 64.
constexpr std::uint32_t times_x(std::uint32_t c, std::uint32_t q) {
  // x^k by what it is congruent to, modulo an irreducible polynomial of degree k.
  const std::uint32_t x_to_degree = q == 32 ? 5u : 3u;
  return q <= 2 ? 0 : (c << 1 ^ ((c & (q >> 1)) != 0 ? x_to_degree : 0)) & (q - 1);
}

/// Which place of its set a sample's point has in a pair of dimensions, where places r * m ... r * m + m - 1,
/// m = count / q, lie in region r of q = matched_regions(count), at least 2. Sample r * m + c has region r +
/// a c and place c there, either under a random digital shift (a rotation where m is no power of two). a is
/// the pair's own element of the field of q: 0 for pair 0, which keeps the samples' order, `one`: 1, else x
/// (0 for q = 2). So of two pairs with different a every region of one meets every region of the other,
/// equally often where q divides m: an orthogonal array of strength 2 (Bush 1952; Owen 1992). With a random
/// key a sample's place is uniform.
constexpr std::uint32_t matched_place(std::uint32_t index, std::uint32_t count, bool one, std::uint32_t key) {
  const std::uint32_t q = matched_regions(count), m = count / q, r = index / m, c = index % m,
                      digit = c & (q - 1);
  const std::uint32_t region = (r ^ (one ? digit : times_x(digit, q)) ^ (key >> 16)) & (q - 1),
                      shift = multiply_high(key, m);
  const std::uint32_t place = (m & (m - 1)) == 0 ? c ^ shift : (c + shift) % m;
  return region * m + place;
}

/// How many points the ranked sets have that `count` are the first of (points/ranked_order.h).
constexpr std::uint32_t ranked_set_points(std::uint32_t count) {
  return count <= 256 ? 256 : 1024;
}

/// The same for ranked sets of `points`, 256 or 1024, where rank c q + t is the t-th of class c: t through a
/// linear map, plus an element of the field times c; c stays. So chosen, by search, that of any two of pair
/// 0, the pair with `one` and the others every region meets every other in whole sets, every eighth every
/// other in the first 64 points and every quarter in the first 16; and that the first 2, 4, 8, ... t stay so.
/// The random shift is not in it.
constexpr std::uint32_t matched_rank(std::uint32_t index, std::uint32_t points, bool one) {
  const std::uint32_t q = matched_regions(points), c = index / q;
  // What bits 2, 3 and 4 of t add to those below them, and the powers of x that c is multiplied by.
  const std::uint32_t adds = one       ? 0x051u
                             : q == 16 ? 0x012u
                                       : 0xc43u,
                      factor = q == 16 ? (one ? 3u : 10u)
                               : one   ? 2u
                                       : 6u;
  std::uint32_t result = index, power = c;
  for (std::uint32_t k = 0; k < 3; ++k)
    if ((index >> (k + 2) & 1) != 0 && (4u << k) < q) result ^= adds >> (4 * k) & 15;
  for (std::uint32_t k = 0; k < 4; ++k, power = times_x(power, q))
    if ((factor >> k & 1) != 0) result ^= power;
  return result;
}

/// Where such a rank's cell is among all of its set, region by region: neighbours are near each other.
constexpr std::uint32_t place_of_rank(std::uint32_t rank, std::uint32_t points) {
  const std::uint32_t k = points > 256 ? 5 : 4, region = ranked_region(rank & ((1u << k) - 1), k);
  return region * (points >> k) + (rank >> k);
}

/// A stride for shuffle_index: coprime to count, near count / golden ratio.
std::uint32_t coprime_stride(std::uint32_t count);

}  // namespace capcon
