// The traversal stack. Its top lies in registers that move by one at a push or a drop: on lavapipe an array is a scalar loop
// over lanes (measured: six times slower in all), a register two blends. What does not fit waits in an array, which is only
// touched between rounds of the node loop: a lane leaves that loop when its registers are full or empty.
layout(constant_id = kSpecStackSize) const uint kWaiting = 16u;  // entries the scene's tree can need beyond the registers

#define STACK \
  uint s0 = 0u, s1 = 0u, s2 = 0u, s3 = 0u, s4 = 0u, s5 = 0u, s6 = 0u, s7 = 0u; \
  uint waiting[kWaiting]; \
  uint waiting_count = 0u;

// A push (of `entry`), or a drop of the top; uses the names push, drop and entry of its place.
#define STACK_MOVE(push, drop, entry) \
  uint m7 = push ? s6 : (drop ? 0u : s7); \
  uint m6 = push ? s5 : (drop ? s7 : s6); \
  uint m5 = push ? s4 : (drop ? s6 : s5); \
  uint m4 = push ? s3 : (drop ? s5 : s4); \
  uint m3 = push ? s2 : (drop ? s4 : s3); \
  uint m2 = push ? s1 : (drop ? s3 : s2); \
  uint m1 = push ? s0 : (drop ? s2 : s1); \
  s0 = push ? entry : (drop ? s1 : s0); \
  s1 = m1; s2 = m2; s3 = m3; s4 = m4; s5 = m5; s6 = m6; s7 = m7;

#define STACK_FULL (s7 != 0u)

// Between rounds: the lowest register moves to the array when all are full.
#define STACK_SPILL \
  { \
    bool spill = STACK_FULL; \
    if (spill) waiting[waiting_count] = s7; \
    waiting_count += spill ? 1u : 0u; \
    s7 = spill ? 0u : s7; \
  }
