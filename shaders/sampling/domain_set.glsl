// Sets of an ensemble in the integral's own domain (host/sampling/domain_sets.cpp). words: sets of the disk, sets of the square,
// -, parts | sets of the cylinder << 16 (0: no table of that domain). Table: a cell a texel, its low corner and its size, first all
// sets of the disk, then those of the square, then those of the cylinder.

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
  uint before = disk ? 0u : cylinder ? words.x + words.y : words.x;
  uint set = multiply_high(keys.w, sets);
  uint place = index;
  if (parts > 1u) {  // which part comes first is random
    uint first = multiply_high(set_words(seed, pixel, dimension, kPurposeParts).w, parts);
    place += count / parts * first;
    place -= place >= count ? count : 0u;
  }
  uvec4 cell = FETCH(sampler_texels, (before + set) * count + place);
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
