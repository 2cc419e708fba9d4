// By what number the component of a BSDF is chosen; host/sampling/choice.h says why and how.

uint permute(uint index, uint count, uint key) {
  uint bits = count > 1u ? uint(findMSB(count - 1u)) + 1u : 1u;
  uint mask = 0xffffffffu >> (32u - bits);
  uint shift = (bits + 1u) >> 1u;
  uint x = index;
  bool going = count > 1u;
  while (going) {
    uint k = key;
    uint y = x;
    for (int round = 0; round < 8; ++round) {
      k = k * 747796405u + 2891336453u;
      y = (y * ((k >> 15u) | 1u) + (k >> 9u)) & mask;
      y ^= y >> shift;
    }
    x = going ? y : x;
    going = x >= count;
  }
  return count > 1u ? x : 0u;
}

uint path_point(uint seed, uint set, uint path, uint paths, uint bounce, uint pair) {
  return permute(path, paths, set_words(seed, bounce, pair, kPurposePaths + set).y);
}

uint component_choice(uint seed, uint pixel, uint part, uint index, uvec4 split, bool separate) {
  uint number = kPairComponent + (part << 16u);
  uint cell = permute(index, split.y, set_words(seed, pixel, number, kPurposeSet).y);
  uint cells = split.y;
  if (!separate && split.x > 1u) {
    cell = cell * split.x + permute(part, split.x, set_words(seed, pixel, kPairComponent, kPurposeFiner + cell).y);
    cells *= split.x;
  }
  uint width = 0xffffffffu / max(cells, 1u);
  uint high, low;
  umulExtended(pcg4d(uvec4(pixel, index, number, seed)).z, width, high, low);
  return cell * width + high;
}
