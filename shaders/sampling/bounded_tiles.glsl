// A stochastic tiling of the square by tiles of a bounded set, a random point in each point's cell, under one of the square's eight
// symmetries (host/sampling/bounded_tiles.cpp). words: tiles of the tiling, points of a tile (with kDealt in corner_tiles.glsl's sense),
// -, colours inside | parts << 8. Table: the tiling's cells (origin, corner vertices as 16-bit pairs, 0xffff outside), then the cells of
// the points of all tile numbers (low corner and size; the width's lowest bits: 1 a twin above, 2 below), then the order of parts.
uint bounded_colour(uint seed, uint pixel, uint dimension, uint vertex, uint outside) {
  return vertex == 0xffffu ? outside : corner_colour(seed, pixel, dimension, vertex);
}

uvec2 sample_bounded_tiles(uvec4 words, uint seed, uint count, uint pixel, uint index, uint dimension) {
  uint ranks = words.y & ~kDealt;
  uint outside = words.w & 0xffu;
  uint colours = outside + 1u;
  uint place_in_order = index;
  if ((words.y & kDealt) != 0u) {
    uint parts = words.w >> 8u;
    uint turn = set_words(seed, pixel, dimension, kPurposeParts).w;
    index += count / parts * multiply_high(turn, parts);
    index -= index >= count ? count : 0u;
    place_in_order = index;
    uint tiles = colours * colours * colours * colours;
    uvec4 four = FETCH(sampler_texels, words.x + tiles * ranks + (index >> 2u));
    uint select = index & 3u;
    uint word = select == 0u ? four.x : select == 1u ? four.y : select == 2u ? four.z : four.w;
    index = (word & 0xffffu) * ranks + (word >> 16u);
  }
  uint at = index / ranks;
  uvec4 cell = FETCH(sampler_texels, at);
  uint tile = bounded_colour(seed, pixel, dimension, cell.z & 0xffffu, outside);
  tile += colours * bounded_colour(seed, pixel, dimension, cell.z >> 16u, outside);
  tile += colours * colours * bounded_colour(seed, pixel, dimension, cell.w & 0xffffu, outside);
  tile += colours * colours * colours * bounded_colour(seed, pixel, dimension, cell.w >> 16u, outside);
  uvec4 place = FETCH(sampler_texels, words.x + tile * ranks + (index - at * ranks));
  // Where in its cell: an Owen-scrambled net over the order of the set or its parts.
  uvec4 within = set_words(seed, pixel, dimension, kPurposeWithin);
  uint u = bitfieldReverse(owen_scramble_reversed(place_in_order, within.z));
  uint v = bitfieldReverse(owen_scramble_reversed(sobol_second_reversed(place_in_order), within.w));
  uint width = place.z & ~3u;
  uint across = multiply_high(u, width);
  uvec2 p = cell.xy + place.xy + uvec2(across, multiply_high(v, place.w));
  bool twin = (place.z & 3u) != 0u && across >= width >> 1u;
  p.y += twin ? ((place.z & 1u) != 0u ? place.w : 0u - place.w) : 0u;
  uint turn = set_words(seed, pixel, dimension, kPurposeSet).y;
  p ^= uvec2((turn & 1u) != 0u ? 0xffffffffu : 0u, (turn & 2u) != 0u ? 0xffffffffu : 0u);
  return (turn & 4u) != 0u ? p.yx : p;
}
