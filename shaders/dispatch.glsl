// Numbers of lanes. A whole number's division is a loop over lanes on lavapipe, a float's one instruction.

// a / b for a < 2^21, b > 0, as all lanes of a batch are (host/render/batches.h): exact, as the quotient of a + 1/2 is further
// from whole numbers than rounding goes (2.5 ulp).
uint divide_small(uint a, uint b) { return uint((float(a) + 0.5) / float(b)); }

// a / b < 2^21, b > 0: exact, as the float's is off by one at most.
uint divide(uint a, uint b) {
  uint quotient = uint(float(a) / float(b));
  uint rest = a - quotient * b;
  return rest >= 0x80000000u ? quotient - 1u : rest >= b ? quotient + 1u : quotient;
}

// The driver may hand each of its threads one contiguous piece of a dispatch: a stride coprime to the number of groups spreads
// the work (host/render/dispatch.h, whose strides keep the product below 2^32).
uint spread_group(uint stride) {
  uint product = gl_WorkGroupID.x * stride;
  return product - divide(product, gl_NumWorkGroups.x) * gl_NumWorkGroups.x;
}

// The place of a lane's pixel among `count` in a row after row order of images of this width: in every two rows blocks of 4 x 2, so
// that lanes that run in step lie close together. What is left of the last two rows keeps its order.
uint block_place(uint lane, uint count, uint width) {
  uint strip = divide_small(lane, 2u * width);
  uint first = strip * 2u * width;
  uint r = lane - first;
  uint blocks = width >> 2u, rest = width & 3u;
  uint beyond = r - 8u * blocks;
  uint row = divide_small(beyond, max(rest, 1u));
  uint in_block = (r >> 3u) * 4u + (r & 3u) + ((r >> 2u) & 1u) * width;
  uint in_rest = 4u * blocks + (beyond - row * rest) + row * width;
  return first + 2u * width > count ? lane : first + (r < 8u * blocks ? in_block : in_rest);
}
