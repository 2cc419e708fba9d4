// The Sobol' (0,2)-sequence, digit-scrambled (XOR) or Owen-scrambled.
uvec2 sample_sobol(bool owen, uvec4 words, uint seed, uint count, uint pixel, uint index, uint dimension) {
  uvec4 keys = set_words(seed, pixel, dimension, kPurposeSet);
  uint second = sobol_second_reversed(index);
  if (owen) {
    return bitfieldReverse(uvec2(owen_scramble_reversed(index, keys.x), owen_scramble_reversed(second, keys.y)));
  }
  return bitfieldReverse(uvec2(index, second)) ^ keys.xy;
}

// The same sequence over the whole image, its pixels along a Z curve (host/sampling/sobol_z.cpp). words: binary digits of an index
// within a pixel, those of a coordinate of the image's tile, -, width of the image.
uvec2 sample_sobol_z(uvec4 words, uint seed, uint pixel, uint index, uint dimension) {
  uint digits = words.y;
  uint x = words.w > 0u ? pixel % words.w : pixel;
  uint y = words.w > 0u ? pixel / words.w : 0u;
  uvec2 tile = uvec2(x, y) >> digits;
  uvec4 keys = set_words(seed, tile.x + (tile.y << 16u), dimension, kPurposeScreen);
  uint mask = (1u << digits) - 1u;
  uvec2 z = uvec2(x, y) & mask;
  z = (z | (z << 8u)) & 0x00ff00ffu;
  z = (z | (z << 4u)) & 0x0f0f0f0fu;
  z = (z | (z << 2u)) & 0x33333333u;
  z = (z | (z << 1u)) & 0x55555555u;
  uint place = ((z.x | (z.y << 1u)) << words.x) | index;
  // The curve's order, scrambled as a tree: what is near stays near.
  uint along = bitfieldReverse(owen_scramble_reversed(bitfieldReverse(place), keys.z));
  return bitfieldReverse(uvec2(owen_scramble_reversed(along, keys.x), owen_scramble_reversed(sobol_second_reversed(along), keys.y)));
}
