// The addresses of random words; host/base/hash.cpp and host/sampling/address.h hold the same functions, tests compare.

// pcg4d: Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020.
uvec4 pcg4d(uvec4 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.w;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v.w += v.y * v.z;
  v ^= v >> 16u;
  v.x += v.y * v.w;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v.w += v.y * v.z;
  return v;
}

const uint kPurposeSet = 0x80000000u;
const uint kPurposeColours = 0x90000000u;
const uint kPurposeParts = 0xa0000000u;
const uint kPurposeWithin = 0xb0000000u;
const uint kPurposeFiner = 0xc0000000u;
const uint kPurposePaths = 0xd0000000u;
const uint kPurposeScreen = 0xe0000000u;
const uint kWithinFactor = 0x9e3779b1u;

uvec4 set_words(uint seed, uint pixel, uint dimension, uint purpose) {
  return pcg4d(uvec4(pixel, purpose, dimension, seed));
}

// floor(a * b / 2^32)
uint multiply_high(uint a, uint b) {
  uint high, low;
  umulExtended(a, b, high, low);
  return high;
}
