// The traversal stack. Its top lies in registers that move by one at a push or a drop: on lavapipe an array is a scalar loop
// over lanes (measured: six times slower in all), a register three blends. What does not fit waits in an array, which is only
// touched between rounds of the node loop: a lane leaves that loop when its registers are full or empty.
layout(constant_id = kSpecStackSize) const uint kWaiting = 16u;  // entries the scene's tree can need beyond the registers

#define STACK \
  uint s0 = 0u, s1 = 0u, s2 = 0u, s3 = 0u, s4 = 0u, s5 = 0u, s6 = 0u, s7 = 0u; \
  uint waiting[kWaiting]; \
  uint waiting_count = 0u;

// A push of `entry`, or a drop of the top, or (`keep`) `kept` in its place; at most one of them. First what a drop leaves, in
// values of their own, then the registers from the bottom up: so every register is written when its old value is no longer
// needed, and the compiler keeps old and new in one place (measured: 8 to 13 % of the whole walk).
#define STACK_MOVE(push, entry, drop, keep, kept) \
  { \
    uint d0 = drop ? s1 : s0, d1 = drop ? s2 : s1, d2 = drop ? s3 : s2, d3 = drop ? s4 : s3; \
    uint d4 = drop ? s5 : s4, d5 = drop ? s6 : s5, d6 = drop ? s7 : s6, d7 = drop ? 0u : s7; \
    s7 = push ? s6 : d7; s6 = push ? s5 : d6; s5 = push ? s4 : d5; s4 = push ? s3 : d4; \
    s3 = push ? s2 : d3; s2 = push ? s1 : d2; s1 = push ? s0 : d1; s0 = push ? entry : (keep ? kept : d0); \
  }

#define STACK_PUSH(push, entry) STACK_MOVE(push, entry, false, false, 0u)

#define STACK_FULL (s7 != 0u)

// Between rounds: the lowest register moves to the array when all are full.
#define STACK_SPILL \
  { \
    bool spill = STACK_FULL; \
    if (spill) waiting[waiting_count] = s7; \
    waiting_count += spill ? 1u : 0u; \
    s7 = spill ? 0u : s7; \
  }

#define STACK_CLEAR(clear) \
  { \
    s0 = clear ? 0u : s0; s1 = clear ? 0u : s1; s2 = clear ? 0u : s2; s3 = clear ? 0u : s3; \
    s4 = clear ? 0u : s4; s5 = clear ? 0u : s5; s6 = clear ? 0u : s6; s7 = clear ? 0u : s7; \
    waiting_count = clear ? 0u : waiting_count; \
  }
