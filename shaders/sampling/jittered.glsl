// One random point in each of columns x rows strata. words: columns, rows | rows of a block << 16, -, parts;
// a block has as many strata as there are parts.

// floor((cell + word / 2^32) / cells * 2^32), by long division in 32 bits: quotient digit by digit.
uint in_stratum(uint cell, uint cells, uint word) {
  uint remainder = cell;
  uint quotient = 0u;
  for (int bit = 31; bit >= 0; --bit) {
    remainder = (remainder << 1u) | ((word >> uint(bit)) & 1u);
    uint digit = remainder >= cells ? 1u : 0u;
    remainder -= digit * cells;
    quotient = (quotient << 1u) | digit;
  }
  return quotient;
}

// cells is a power of two: shifts do.
uint in_stratum_power(uint cell, uint cells, uint word) {
  uint bits = uint(findMSB(cells));
  return bits == 0u ? word : (cell << (32u - bits)) | (word >> bits);
}

// The stratum of a point: with parts, the part's own one in block i (host/sampling/jittered.cpp).
uvec2 stratum_of(uvec4 words, uint seed, uint count, uint pixel, uint index, uint dimension) {
  uint parts = words.w;
  uint points = count / parts;
  uint part = index / points;
  uint block = index - part * points;
  uint turn = set_words(seed, pixel, dimension, kPurposeParts + block).w;
  uint place = (part + multiply_high(turn, parts)) % parts;
  uint high = words.y >> 16u;
  uint wide = parts / high;
  uint across = words.x / wide;
  uint row = block / across;
  return uvec2((block - row * across) * wide + place % wide, row * high + place / wide);
}

uvec2 sample_jittered(uvec4 words, uint seed, uint count, uint pixel, uint index, uint dimension) {
  uvec4 random = pcg4d(uvec4(pixel, index, dimension, seed));
  uint rows = words.y & 0xffffu;
  uint row = index / words.x;
  uvec2 stratum = uvec2(index - row * words.x, row);
  if (words.w > 1u) stratum = stratum_of(words, seed, count, pixel, index, dimension);
  if ((count & (count - 1u)) == 0u) {
    return uvec2(in_stratum_power(stratum.x, words.x, random.x), in_stratum_power(stratum.y, rows, random.y));
  }
  return uvec2(in_stratum(stratum.x, words.x, random.x), in_stratum(stratum.y, rows, random.y));
}
