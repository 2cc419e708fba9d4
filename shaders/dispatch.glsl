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
