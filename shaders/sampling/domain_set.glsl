// Sets of an ensemble in the integral's own domain (host/sampling/domain_sets.cpp). words: sets of the disk, sets of the square,
// -, parts | sets of the cylinder << 16 (0: no table of that domain). Table, first of the disk, then of the square and the
// cylinder: a cell a texel, its low corner and its size, set by set; with parts, the place in its set of each point, part by part,
// four to a texel.

// The rotation of the disk by turn / 2^32, in the square that the concentric map takes there: a circle is the rim of a
// square, and its angle goes evenly along the rim. 28 bits of each coordinate.
uvec2 turn_in_square(uvec2 p, uint turn) {
  int x = int(p.x ^ 0x80000000u) >> 4;
  int y = int(p.y ^ 0x80000000u) >> 4;
  int r = max(abs(x), abs(y));
  bool wide = abs(x) >= abs(y);
  // From the corner below right, anticlockwise: right, upper, left and lower side, 2 r each.
  uint along = wide ? (x > 0 ? uint(y + r) : uint(5 * r - y)) : (y > 0 ? uint(3 * r - x) : uint(7 * r + x));
  uint rim = 8u * uint(r);
  along += multiply_high(turn, rim);
  along -= along >= rim ? rim : 0u;
  uint side = r == 0 ? 0u : along / uint(2 * r);
  int rest = int(along - side * uint(2 * r)) - r;
  int u = side == 0u ? r : (side == 1u ? -rest : (side == 2u ? -r : rest));
  int v = side == 0u ? rest : (side == 1u ? r : (side == 2u ? -rest : -r));
  // r itself is the far edge, just outside.
  return uvec2(uint(min(u, 0x7ffffff) << 4) ^ 0x80000000u, uint(min(v, 0x7ffffff) << 4) ^ 0x80000000u);
}

uvec2 sample_domain_set(uvec4 words, uint seed, uint count, uint pixel, uint index, uint dimension,
                        uint domain) {
  uvec4 keys = set_words(seed, pixel, dimension, kPurposeSet);
  uvec4 within = set_words(seed, pixel, dimension, kPurposeWithin);
  uint parts = words.w & 0xffffu;
  bool disk = domain == kDomainDisk;
  bool cylinder = domain == kDomainCylinder;
  uint sets = disk ? words.x : cylinder ? words.w >> 16u : words.y;
  uint split = parts > 1u ? 1u : 0u;
  uint disk_texels = words.x * count + split * ((words.x * count + 3u) >> 2u);
  uint square_texels = words.y * count + split * ((words.y * count + 3u) >> 2u);
  uint before = disk ? 0u : disk_texels + (cylinder ? square_texels : 0u);
  uint set = multiply_high(keys.w, sets) * count;
  uint place = index;
  if (parts > 1u) {
    // Which part comes first is random; then the table has the places in the set's own order.
    uint turn = set_words(seed, pixel, dimension, kPurposeParts).w;
    place += count / parts * multiply_high(turn, parts);
    place -= place >= count ? count : 0u;
    uvec4 four = FETCH(sampler_texels, before + sets * count + ((set + place) >> 2u));
    uint select = (set + place) & 3u;
    place = select == 0u ? four.x : select == 1u ? four.y : select == 2u ? four.z : four.w;
  }
  uvec4 cell = FETCH(sampler_texels, before + set + place);
  // Where in its cell: an Owen-scrambled net over the set's order.
  uint u = bitfieldReverse(owen_scramble_reversed(place, within.z));
  uint v = bitfieldReverse(owen_scramble_reversed(sobol_second_reversed(place), within.w));
  uvec2 p = cell.xy + uvec2(multiply_high(u, cell.z), multiply_high(v, cell.w));
  if (cylinder) return uvec2(p.x + keys.y, (within.y & 1u) != 0u ? ~p.y : p.y);
  uvec2 turned = turn_in_square(p, keys.y);
  // The square's eight symmetries: either coordinate from the other side, and the two exchanged.
  uvec2 flipped = p ^ uvec2((keys.y & 1u) != 0u ? 0xffffffffu : 0u, (keys.y & 2u) != 0u ? 0xffffffffu : 0u);
  flipped = (keys.y & 4u) != 0u ? flipped.yx : flipped;
  return disk ? turned : flipped;
}
