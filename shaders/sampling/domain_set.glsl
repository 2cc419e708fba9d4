// Sets of an ensemble in the integral's own domain (host/sampling/domain_sets.cpp). words: sets of the disk, sets of the square,
// -, parts | sets of the cylinder << 16 (0: no table of that domain). Table, first of the disk, then of the square and the
// cylinder: a cell a texel, its low corner and its size, set by set; with parts, the place in its set of each point, part by part,
// four to a texel.
// kSamplerCapconRanked has sets of 256 or 1,024 points of which the first are taken (host/sampling/ranked_sets.cpp).
// kSamplerCapconScreen has the image's width in place of the parts, which are the upper half of the third word, and after all
// cells the masks of the same domains: eight keys a texel.

// The key of a pixel's set (host/points/screen_mask.h).
uint screen_key(uint before, uint sets, uint width, uint pixel, uvec4 image) {
  uint x = width > 0u ? pixel % width : pixel;
  uint y = width > 0u ? pixel / width : 0u;
  uint least = sets >> min(3u, uint(findLSB(sets)));
  uint rows = least * ((63u + least) / least);
  uint place = ((x + image.y) & 63u) + 64u * ((y + (image.z >> 16u)) % rows);
  uvec4 keys = FETCH(sampler_texels, before + (place >> 3u));
  uint select = (place >> 1u) & 3u;
  uint two = select == 0u ? keys.x : select == 1u ? keys.y : select == 2u ? keys.z : keys.w;
  return (place & 1u) != 0u ? two >> 16u : two & 0xffffu;
}

uint mask_texels(uint sets) {
  uint least = max(1u, sets >> min(3u, uint(findLSB(max(1u, sets)))));
  return sets > 0u ? 8u * least * ((63u + least) / least) : 0u;
}


uvec2 sample_domain_set(uvec4 words, uint seed, uint count, uint pixel, uint index, uint dimension,
                        uint domain) {
  uvec4 keys = set_words(seed, pixel, dimension, kPurposeSet);
  uvec4 within = set_words(seed, pixel, dimension, kPurposeWithin);
  bool screen = kSampler == kSamplerCapconScreen;
  uint parts = screen ? words.z >> 16u : words.w & 0xffffu;
  bool disk = domain == kDomainDisk;
  bool cylinder = domain == kDomainCylinder;
  uint round_sets = words.w >> 16u;
  uint sets = disk ? words.x : cylinder ? round_sets : words.y;
  uint split = parts > 1u ? 1u : 0u;
  bool ranked = kSampler == kSamplerCapconRanked;
  if (ranked) {
    count = ranked_set_points(count);
    index ^= set_words(seed, pixel, dimension, kPurposeParts).w & (count - 1u);
  }
  uint disk_texels = words.x * count + split * ((words.x * count + 3u) >> 2u);
  uint square_texels = words.y * count + split * ((words.y * count + 3u) >> 2u);
  uint before = disk ? 0u : disk_texels + (cylinder ? square_texels : 0u);
  uint set = multiply_high(keys.w, sets);
  uint flips = cylinder ? within.y : keys.y;
  uint turn = keys.y;
  if (screen) {
    uvec4 image = set_words(seed, 0u, dimension, kPurposeScreen);
    uint masks = disk_texels + square_texels + round_sets * count + split * ((round_sets * count + 3u) >> 2u);
    uint mask = masks + (disk ? 0u : mask_texels(words.x) + (cylinder ? mask_texels(words.y) : 0u));
    uint key = screen_key(mask, sets, words.w & 0xffffu, pixel, image);
    set = key >> 3u;
    flips = key;
    turn = ((key >> 1u) & 3u) * 0x40000000u + image.w;
  }
  set *= count;
  uint place = index;
  if (parts > 1u) {
    // Which part comes first is random; then the table has the places in the set's own order.
    uint first = set_words(seed, pixel, dimension, kPurposeParts).w;
    place += count / parts * multiply_high(first, parts);
    place -= place >= count ? count : 0u;
    uvec4 four = FETCH(sampler_texels, before + sets * count + ((set + place) >> 2u));
    uint select = (set + place) & 3u;
    place = select == 0u ? four.x : select == 1u ? four.y : select == 2u ? four.z : four.w;
  }
  uvec4 cell = FETCH(sampler_texels, before + set + place);
  // Where in its cell: an Owen-scrambled net over the set's order.
  uint near = ranked ? place_of_rank(place, count) : place;
  uint u = bitfieldReverse(owen_scramble_reversed(near, within.z));
  uint v = bitfieldReverse(owen_scramble_reversed(sobol_second_reversed(near), within.w));
  uvec2 p = cell.xy + uvec2(multiply_high(u, cell.z), multiply_high(v, cell.w));
  if (cylinder) return uvec2(p.x + turn, (flips & 1u) != 0u ? ~p.y : p.y);
  // The square's eight symmetries, which the concentric map makes the disk's: either coordinate from the other side, and the two
  // exchanged.
  uvec2 flipped = p ^ uvec2((flips & 1u) != 0u ? 0xffffffffu : 0u, (flips & 2u) != 0u ? 0xffffffffu : 0u);
  return (flips & 4u) != 0u ? flipped.yx : flipped;
}
