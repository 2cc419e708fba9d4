// Stored sets, shifted on the torus by 32-bit addition (host/sampling/rotated_set.cpp, stored_sets.cpp). words: sets (0 is 1 too), of which
// one is chosen; whether they are left as they are. Table: one point a texel, set by set.
uvec2 sample_rotated_set(uvec4 words, uint seed, uint count, uint pixel, uint index, uint dimension) {
  uvec4 keys = set_words(seed, pixel, dimension, kPurposeSet);
  uvec2 point = FETCH(sampler_texels, multiply_high(keys.w, words.x) * count + index).xy;
  return words.y != 0u ? point : point + keys.xy;
}
