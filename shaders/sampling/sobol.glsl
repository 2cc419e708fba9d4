// The Sobol' (0,2)-sequence, digit-scrambled (XOR) or Owen-scrambled.
uvec2 sample_sobol(bool owen, uvec4 words, uint seed, uint count, uint pixel, uint index, uint dimension) {
  uvec4 keys = set_words(seed, pixel, dimension, kPurposeSet);
  uint second = sobol_second_reversed(index);
  if (owen) {
    return bitfieldReverse(uvec2(owen_scramble_reversed(index, keys.x), owen_scramble_reversed(second, keys.y)));
  }
  return bitfieldReverse(uvec2(index, second)) ^ keys.xy;
}
