// A stochastic toroidal tiling of corner tiles, shifted on the torus (host/sampling/corner_tiles.cpp). words: tiles, ranks, -,
// extra. Table: cells (origin, corner vertices as 16-bit pairs), then the points of the 16 tiles, turned and scaled. With
// kDealt in the second word, then the order of the points, part by part, four to a texel: cell | slot << 16. Ranks 0: the
// points of every colouring of few tiles, part by part.
const uint kDealt = 0x80000000u;

uint corner_colour(uint seed, uint pixel, uint dimension, uint vertex) {
  uvec4 words = set_words(seed, pixel, dimension, kPurposeColours + (vertex >> 7u));
  uint select = (vertex >> 5u) & 3u;
  uint word = select == 0u ? words.x : select == 1u ? words.y : select == 2u ? words.z : words.w;
  return (word >> (vertex & 31u)) & 1u;
}

uvec2 sample_corner_tiles(uvec4 words, uint seed, uint count, uint pixel, uint index, uint dimension) {
  uvec4 keys = set_words(seed, pixel, dimension, kPurposeSet);
  if (words.y == 0u) {
    uint colouring = set_words(seed, pixel, dimension, kPurposeColours).x & ((1u << words.x) - 1u);
    return FETCH(sampler_texels, colouring * count + index).xy + keys.xy;
  }
  uint ranks = words.y & ~kDealt;
  uint stored = ranks + (words.w > 0u ? 1u : 0u);
  uint cell, rank;
  if ((words.y & kDealt) != 0u) {
    uvec4 four = FETCH(sampler_texels, words.x + 16u * stored + (index >> 2u));
    uint select = index & 3u;
    uint word = select == 0u ? four.x : select == 1u ? four.y : select == 2u ? four.z : four.w;
    cell = word & 0xffffu;
    rank = word >> 16u;
  } else {
    uint longer = words.w * (ranks + 1u);
    bool in_longer = index < longer;
    uint from = in_longer ? index : index - longer;
    uint points = ranks + (in_longer ? 1u : 0u);
    uint at = from / points;
    cell = at + (in_longer ? 0u : words.w);
    rank = from - at * points;
  }
  uvec4 place = FETCH(sampler_texels, cell);
  uint tile = corner_colour(seed, pixel, dimension, place.z & 0xffffu);
  tile |= corner_colour(seed, pixel, dimension, place.z >> 16u) << 1u;
  tile |= corner_colour(seed, pixel, dimension, place.w & 0xffffu) << 2u;
  tile |= corner_colour(seed, pixel, dimension, place.w >> 16u) << 3u;
  return place.xy + FETCH(sampler_texels, words.x + tile * stored + rank).xy + keys.xy;
}
