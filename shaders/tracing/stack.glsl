// The traversal stack: registers that move by one at a push or a pop. An array would be a scalar loop over lanes on lavapipe
// (measured: six times slower in all); a blend a register is not. The specialisation constant says how many the scene's
// tree can need; the rest hold a constant and fall out of the kernel. At most kStackLimit (host/render/renderer_state.cpp).
layout(constant_id = kSpecStackSize) const uint kStackSize = 16u;

#define STACK_REGISTERS \
  uint s0 = 0u, s1 = 0u, s2 = 0u, s3 = 0u, s4 = 0u, s5 = 0u, s6 = 0u, s7 = 0u; \
  uint s8 = 0u, s9 = 0u, s10 = 0u, s11 = 0u, s12 = 0u, s13 = 0u, s14 = 0u, s15 = 0u; \
  uint s16 = 0u, s17 = 0u, s18 = 0u, s19 = 0u, s20 = 0u, s21 = 0u, s22 = 0u, s23 = 0u; \
  uint s24 = 0u, s25 = 0u, s26 = 0u, s27 = 0u, s28 = 0u, s29 = 0u, s30 = 0u, s31 = 0u; \
  uint s32 = 0u, s33 = 0u, s34 = 0u, s35 = 0u, s36 = 0u, s37 = 0u, s38 = 0u, s39 = 0u;

// A push moves every register down by one, a drop of the top moves them up. Uses the names push and drop of its place.
#define STACK_SHIFT \
  uint m1 = kStackSize > 1u ? (push ? s0 : (drop ? s2 : s1)) : 0u; \
  uint m2 = kStackSize > 2u ? (push ? s1 : (drop ? s3 : s2)) : 0u; \
  uint m3 = kStackSize > 3u ? (push ? s2 : (drop ? s4 : s3)) : 0u; \
  uint m4 = kStackSize > 4u ? (push ? s3 : (drop ? s5 : s4)) : 0u; \
  uint m5 = kStackSize > 5u ? (push ? s4 : (drop ? s6 : s5)) : 0u; \
  uint m6 = kStackSize > 6u ? (push ? s5 : (drop ? s7 : s6)) : 0u; \
  uint m7 = kStackSize > 7u ? (push ? s6 : (drop ? s8 : s7)) : 0u; \
  uint m8 = kStackSize > 8u ? (push ? s7 : (drop ? s9 : s8)) : 0u; \
  uint m9 = kStackSize > 9u ? (push ? s8 : (drop ? s10 : s9)) : 0u; \
  uint m10 = kStackSize > 10u ? (push ? s9 : (drop ? s11 : s10)) : 0u; \
  uint m11 = kStackSize > 11u ? (push ? s10 : (drop ? s12 : s11)) : 0u; \
  uint m12 = kStackSize > 12u ? (push ? s11 : (drop ? s13 : s12)) : 0u; \
  uint m13 = kStackSize > 13u ? (push ? s12 : (drop ? s14 : s13)) : 0u; \
  uint m14 = kStackSize > 14u ? (push ? s13 : (drop ? s15 : s14)) : 0u; \
  uint m15 = kStackSize > 15u ? (push ? s14 : (drop ? s16 : s15)) : 0u; \
  uint m16 = kStackSize > 16u ? (push ? s15 : (drop ? s17 : s16)) : 0u; \
  uint m17 = kStackSize > 17u ? (push ? s16 : (drop ? s18 : s17)) : 0u; \
  uint m18 = kStackSize > 18u ? (push ? s17 : (drop ? s19 : s18)) : 0u; \
  uint m19 = kStackSize > 19u ? (push ? s18 : (drop ? s20 : s19)) : 0u; \
  uint m20 = kStackSize > 20u ? (push ? s19 : (drop ? s21 : s20)) : 0u; \
  uint m21 = kStackSize > 21u ? (push ? s20 : (drop ? s22 : s21)) : 0u; \
  uint m22 = kStackSize > 22u ? (push ? s21 : (drop ? s23 : s22)) : 0u; \
  uint m23 = kStackSize > 23u ? (push ? s22 : (drop ? s24 : s23)) : 0u; \
  uint m24 = kStackSize > 24u ? (push ? s23 : (drop ? s25 : s24)) : 0u; \
  uint m25 = kStackSize > 25u ? (push ? s24 : (drop ? s26 : s25)) : 0u; \
  uint m26 = kStackSize > 26u ? (push ? s25 : (drop ? s27 : s26)) : 0u; \
  uint m27 = kStackSize > 27u ? (push ? s26 : (drop ? s28 : s27)) : 0u; \
  uint m28 = kStackSize > 28u ? (push ? s27 : (drop ? s29 : s28)) : 0u; \
  uint m29 = kStackSize > 29u ? (push ? s28 : (drop ? s30 : s29)) : 0u; \
  uint m30 = kStackSize > 30u ? (push ? s29 : (drop ? s31 : s30)) : 0u; \
  uint m31 = kStackSize > 31u ? (push ? s30 : (drop ? s32 : s31)) : 0u; \
  uint m32 = kStackSize > 32u ? (push ? s31 : (drop ? s33 : s32)) : 0u; \
  uint m33 = kStackSize > 33u ? (push ? s32 : (drop ? s34 : s33)) : 0u; \
  uint m34 = kStackSize > 34u ? (push ? s33 : (drop ? s35 : s34)) : 0u; \
  uint m35 = kStackSize > 35u ? (push ? s34 : (drop ? s36 : s35)) : 0u; \
  uint m36 = kStackSize > 36u ? (push ? s35 : (drop ? s37 : s36)) : 0u; \
  uint m37 = kStackSize > 37u ? (push ? s36 : (drop ? s38 : s37)) : 0u; \
  uint m38 = kStackSize > 38u ? (push ? s37 : (drop ? s39 : s38)) : 0u; \
  uint m39 = kStackSize > 39u ? (push ? s38 : (drop ? 0u : s39)) : 0u; \
  s1 = m1; s2 = m2; s3 = m3; s4 = m4; s5 = m5; s6 = m6; \
  s7 = m7; s8 = m8; s9 = m9; s10 = m10; s11 = m11; s12 = m12; \
  s13 = m13; s14 = m14; s15 = m15; s16 = m16; s17 = m17; s18 = m18; \
  s19 = m19; s20 = m20; s21 = m21; s22 = m22; s23 = m23; s24 = m24; \
  s25 = m25; s26 = m26; s27 = m27; s28 = m28; s29 = m29; s30 = m30; \
  s31 = m31; s32 = m32; s33 = m33; s34 = m34; s35 = m35; s36 = m36; \
  s37 = m37; s38 = m38; s39 = m39;
