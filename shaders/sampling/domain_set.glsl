// Sets of an ensemble in the integral's own domain (host/sampling/domain_sets.cpp). words: sets of the disk, sets of the square,
// -, parts | sets of the cylinder << 16 (0: no table of that domain). Table, first of the disk, then of the square and the
// cylinder: a cell a texel, set by set, each with room for a power of two of them, and part by part: its column and row, where in
// it the set's net has its point, and the size of a column and of a row.
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

// The least power of two that is not less; at most 4,096 points.
uint set_stride(uint count) {
  uint mask = max(count, 1u) - 1u;
  mask |= mask >> 1u;
  mask |= mask >> 2u;
  mask |= mask >> 4u;
  mask |= mask >> 8u;
  return mask + 1u;
}

uvec2 sample_domain_set(uvec4 words, uint seed, uint count, uint pixel, uint index, uint dimension,
                        uint domain) {
  uvec4 keys = set_words(seed, pixel, dimension, kPurposeSet);
  bool screen = kSampler == kSamplerCapconScreen;
  bool disk = domain == kDomainDisk;
  bool cylinder = domain == kDomainCylinder;
  uint round_sets = words.w >> 16u;
  uint sets = disk ? words.x : cylinder ? round_sets : words.y;
  if (kSampler == kSamplerCapconRanked) {
    count = ranked_set_points(count);
    index ^= set_words(seed, pixel, dimension, kPurposeParts).w & (count - 1u);
  }
  uint stride = set_stride(count);
  uint disk_texels = words.x * stride;
  uint square_texels = words.y * stride;
  uint before = disk ? 0u : disk_texels + (cylinder ? square_texels : 0u);
  // The table is waited for, the more so the later its address is known: of the hash's words y is done before w, and of the set's
  // number times the stride, which is a power of two, no product is taken.
  uint set = multiply_high(keys.y, sets * stride) & (0u - stride);
  // The symmetry is a word's highest bits (the lowest are those of other purposes' w, too), the first shift its others; the set is
  // another's highest, the second shift all of its.
  uint flips = keys.w >> 29u;
  uint turn = keys.w;
  uvec2 key = uvec2(keys.w << 3u, keys.y * kWithinFactor);
  if (cylinder) {
    uvec4 within = set_words(seed, pixel, dimension, kPurposeWithin);
    flips = within.y;
    key = within.zw;
  }
  if (screen) {
    uvec4 image = set_words(seed, 0u, dimension, kPurposeScreen);
    uint masks = disk_texels + square_texels + round_sets * stride;
    uint mask = masks + (disk ? 0u : mask_texels(words.x) + (cylinder ? mask_texels(words.y) : 0u));
    uint screen = screen_key(mask, sets, words.w & 0xffffu, pixel, image);
    set = (screen >> 3u) * stride;
    flips = screen;
    turn = ((screen >> 1u) & 3u) * 0x40000000u + image.w;
  }
  uint place = index;
  if (kInParts) {
    // Which part comes first is random.
    uint parts = screen ? words.z >> 16u : words.w & 0xffffu;
    uint first = set_words(seed, pixel, dimension, kPurposeParts).w;
    place += divide_small(count, parts) * multiply_high(first, parts);
    place -= place >= count ? count : 0u;
  }
  uvec4 cell = FETCH(sampler_texels, before + set + place);
  // Where in its cell: the net over the set's order, under a random digital shift.
  uvec2 in_cell = uvec2(cell.y << 16u, cell.y & 0xffff0000u) ^ key;
  uvec2 p = uvec2(cell.x & 0xffffu, cell.x >> 16u) * cell.zw + uvec2(multiply_high(in_cell.x, cell.z), multiply_high(in_cell.y, cell.w));
  if (cylinder) return uvec2(p.x + turn, (flips & 1u) != 0u ? ~p.y : p.y);
  // The square's eight symmetries, which the concentric map makes the disk's: either coordinate from the other side, and the two
  // exchanged.
  uvec2 flipped = p ^ uvec2((flips & 1u) != 0u ? 0xffffffffu : 0u, (flips & 2u) != 0u ? 0xffffffffu : 0u);
  return (flips & 4u) != 0u ? flipped.yx : flipped;
}
