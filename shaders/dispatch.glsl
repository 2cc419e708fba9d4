// Numbers of lanes. A whole number's division is a loop over lanes on lavapipe, a float's one instruction.

// a / b for a < 2^21, b > 0: exact, as the quotient of a + 1/2 is further from whole numbers than rounding goes (2.5 ulp).
uint divide(uint a, uint b) { return uint((float(a) + 0.5) / float(b)); }

// The driver may hand each of its threads one contiguous piece of a dispatch: a stride coprime to the number of groups spreads
// the work. Fewer than 2^15 groups (host/render/batches.h): the product is below 2^30, the quotient off by one at most.
uint spread_group(uint stride) {
  uint groups = gl_NumWorkGroups.x;
  uint product = gl_WorkGroupID.x * stride;
  uint rest = product - uint(float(product) / float(groups)) * groups;
  rest += rest >= 0x80000000u ? groups : 0u;
  return rest >= groups ? rest - groups : rest;
}
