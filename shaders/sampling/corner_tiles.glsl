// A stochastic toroidal tiling of corner tiles, shifted on the torus. words: tiles, ranks, -, extra.
// Table: cells (origin, corner vertices as 16-bit pairs), then the points of the 16 tiles, turned and scaled.

uint corner_colour(uint seed, uint pixel, uint dimension, uint vertex) {
  uvec4 words = set_words(seed, pixel, dimension, kPurposeColours + (vertex >> 7u));
  uint select = (vertex >> 5u) & 3u;
  uint word = select == 0u ? words.x : select == 1u ? words.y : select == 2u ? words.z : words.w;
  return (word >> (vertex & 31u)) & 1u;
}

uvec2 sample_corner_tiles(uvec4 words, uint seed, uint count, uint pixel, uint index, uint dimension) {
  uvec4 keys = set_words(seed, pixel, dimension, kPurposeSet);
  uint longer = words.w * (words.y + 1u);
  bool in_longer = index < longer;
  uint from = in_longer ? index : index - longer;
  uint points = words.y + (in_longer ? 1u : 0u);
  uint cell = from / points;
  uint rank = from - cell * points;
  uvec4 place = FETCH(sampler_texels, cell + (in_longer ? 0u : words.w));
  uint tile = corner_colour(seed, pixel, dimension, place.z & 0xffffu);
  tile |= corner_colour(seed, pixel, dimension, place.z >> 16u) << 1u;
  tile |= corner_colour(seed, pixel, dimension, place.w & 0xffffu) << 2u;
  tile |= corner_colour(seed, pixel, dimension, place.w >> 16u) << 3u;
  uint stored = words.y + (words.w > 0u ? 1u : 0u);
  return place.xy + FETCH(sampler_texels, words.x + tile * stored + rank).xy + keys.xy;
}
