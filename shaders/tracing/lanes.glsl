// Whether any lane that runs in step with this one wants it. An answer that covers only some of them costs time, never
// correctness: nothing that a ray meets depends on it. Votes are a scalar loop over lanes on lavapipe, shuffles one instruction;
// all lanes of a subgroup must be there.
#extension GL_KHR_shader_subgroup_shuffle : require
#ifdef FETCH_TEXEL
bool any_lane(bool wants) {
  uint v = wants ? 1u : 0u;
  v |= subgroupShuffleXor(v, 1u);
  v |= subgroupShuffleXor(v, 2u);
  if (gl_SubgroupSize > 4u) v |= subgroupShuffleXor(v, 4u);
  if (gl_SubgroupSize > 8u) v |= subgroupShuffleXor(v, 8u);
  return v != 0u;
}

// How many lanes want it, told to all of them. All lanes of a subgroup must be there, and take part.
uint lanes_with(bool wants) {
  uint v = wants ? 1u : 0u;
  v += subgroupShuffleXor(v, 1u);
  v += subgroupShuffleXor(v, 2u);
  uint half8 = subgroupShuffleXor(v, 4u);
  v += gl_SubgroupSize > 4u ? half8 : 0u;
  uint half16 = subgroupShuffleXor(v, 8u);
  v += gl_SubgroupSize > 8u ? half16 : 0u;
  return v;
}
#else
#extension GL_KHR_shader_subgroup_vote : require
bool any_lane(bool wants) { return subgroupAny(wants); }
#endif

// Of up to eight lanes that run in step and have one place, one gets the sum of what all have, the others 0: an atomic addition
// takes as long as twenty instructions. Sums are right whatever lanes run in step.
uint gathered(uint value, uint place) {
  for (uint step = 1u; step <= 4u && step < gl_SubgroupSize; step <<= 1u) {
    uint other = subgroupShuffleXor(value, step);
    bool meets = subgroupShuffleXor(place, step) == place;
    bool lower = (gl_SubgroupInvocationID & step) == 0u;
    value = meets ? (lower ? value + other : 0u) : value;
  }
  return value;
}
