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
