// One random point in each of columns x rows strata. words: columns, rows.

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

uvec2 sample_jittered(uvec4 words, uint seed, uint count, uint pixel, uint index, uint dimension) {
  uvec4 random = pcg4d(uvec4(pixel, index, dimension, seed));
  uint column = index % words.x;
  uint row = index / words.x;
  if ((count & (count - 1u)) == 0u) {
    return uvec2(in_stratum_power(column, words.x, random.x), in_stratum_power(row, words.y, random.y));
  }
  return uvec2(in_stratum(column, words.x, random.x), in_stratum(row, words.y, random.y));
}
