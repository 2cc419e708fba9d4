// Whether any lane that runs in step with this one wants it. An answer that covers only some of them costs time, never
// correctness: nothing that a ray meets depends on it. Votes are a scalar loop over lanes on lavapipe, shuffles one instruction;
// all lanes of a subgroup must be there.
#ifdef FETCH_TEXEL
#extension GL_KHR_shader_subgroup_shuffle : require
bool any_lane(bool wants) {
  uint v = wants ? 1u : 0u;
  v |= subgroupShuffleXor(v, 1u);
  v |= subgroupShuffleXor(v, 2u);
  if (gl_SubgroupSize > 4u) v |= subgroupShuffleXor(v, 4u);
  if (gl_SubgroupSize > 8u) v |= subgroupShuffleXor(v, 8u);
  return v != 0u;
}
#else
#extension GL_KHR_shader_subgroup_vote : require
bool any_lane(bool wants) { return subgroupAny(wants); }
#endif
