// One of several stored sequences, digit-scrambled (host/sampling/pmj02.cpp). words: sequences. Table: two points a texel,
// sequence by sequence.
uvec2 sample_pmj02(uvec4 words, uint seed, uint count, uint pixel, uint index, uint dimension) {
  uvec4 keys = set_words(seed, pixel, dimension, kPurposeSet);
  uint place = multiply_high(keys.w, words.x) * count + index;
  uvec4 two = FETCH(sampler_texels, place >> 1u);
  return ((place & 1u) != 0u ? two.zw : two.xy) ^ keys.xy;
}
