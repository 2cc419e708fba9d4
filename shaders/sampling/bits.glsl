// Bit functions of the nets and of index shuffling; host/sampling/bits.h says what they are and where they come from.

uint sobol_second_reversed(uint index) {
  index ^= (index >> 1u) & 0x55555555u;
  index ^= (index >> 2u) & 0x33333333u;
  index ^= (index >> 4u) & 0x0f0f0f0fu;
  index ^= (index >> 8u) & 0x00ff00ffu;
  return index ^ ((index >> 16u) & 0x0000ffffu);
}

uint owen_scramble_reversed(uint v, uint key) {
  v ^= v * 0x3d20adeau;
  v += key;
  v *= (key >> 16u) | 1u;
  v ^= v * 0x05526c56u;
  v ^= v * 0x53a22864u;
  return v;
}

// (a * b + c) mod m without overflow, for a, b, c < m: 64-bit arithmetic by the device's extended multiply.
uint multiply_add_modulo(uint a, uint b, uint c, uint m) {
  uint high, low;
  umulExtended(a, b, high, low);
  uint carry;
  low = uaddCarry(low, c, carry);
  high += carry;
  // Remainder of high:low by m, a bit at a time; few sets have a count that is no power of two.
  uint remainder = high % m;
  for (int bit = 31; bit >= 0; --bit) {
    uint top = remainder >> 31u;
    remainder = (remainder << 1u) | ((low >> uint(bit)) & 1u);
    remainder -= (top != 0u || remainder >= m) ? m : 0u;
  }
  return remainder;
}

uint shuffle_index(uint index, uint count, uint stride, uint key) {
  if ((count & (count - 1u)) == 0u) {
    return bitfieldReverse(owen_scramble_reversed(bitfieldReverse(index), key)) & (count - 1u);
  }
  return multiply_add_modulo(index, stride, key % count, count);
}

uint matched_regions(uint count) { return min(1u << (uint(findMSB(count)) >> 1u), count & (0u - count)); }

uint times_x(uint c, uint q) { return q > 2u ? (c << 1u ^ ((c & (q >> 1u)) != 0u ? (q == 32u ? 5u : 3u) : 0u)) & (q - 1u) : 0u; }

uint matched_place(uint index, uint count, bool one, uint key) {
  uint q = matched_regions(count);
  uint m = count >> uint(findMSB(q));
  uint r = uint((float(index) + 0.5) / float(m));  // both below 4097: exact, and quicker than whole numbers' division
  uint c = index - r * m;
  uint digit = c & (q - 1u);
  uint region = (r ^ (one ? digit : times_x(digit, q)) ^ (key >> 16u)) & (q - 1u);
  uint shift = multiply_high(key, m);
  uint turned = c + shift;
  return region * m + ((m & (m - 1u)) == 0u ? c ^ shift : turned >= m ? turned - m : turned);
}

uint ranked_set_points(uint count) { return count <= 256u ? 256u : 1024u; }

uint matched_rank(uint index, uint points, bool one) {
  bool large = points > 256u;
  uint q = large ? 32u : 16u;
  uint c = index / q;
  uint adds = one ? 0x051u : large ? 0xc43u : 0x012u;
  uint factor = large ? (one ? 2u : 6u) : one ? 3u : 10u;
  uint result = index;
  result ^= (index & 4u) != 0u ? adds & 15u : 0u;
  result ^= (index & 8u) != 0u ? adds >> 4u & 15u : 0u;
  result ^= (index & 16u) != 0u && large ? adds >> 8u & 15u : 0u;
  for (uint k = 0u; k < 4u; ++k) {
    result ^= (factor >> k & 1u) != 0u ? c : 0u;
    c = times_x(c, q);
  }
  return result;
}
