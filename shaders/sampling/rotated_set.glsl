// One stored set, shifted on the torus by 32-bit addition. Table: one point a texel.
uvec2 sample_rotated_set(uvec4 words, uint seed, uint count, uint pixel, uint index, uint dimension) {
  uvec4 keys = set_words(seed, pixel, dimension, kPurposeSet);
  return FETCH(sampler_texels, index).xy + keys.xy;
}
