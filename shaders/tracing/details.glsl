// What shading needs of a primitive (host/render/geometry.h): one texel with light and material, two more where the scene has normals,
// two more where it has uvs.
layout(constant_id = kSpecDetailNormals) const uint kDetailNormals = 0u;
layout(constant_id = kSpecDetailUvs) const uint kDetailUvs = 0u;
DATA_TEXELS(kBindDetails, detail_texels);

struct Details {
  vec3 normal;    // interpolated, in the space of the primitive's tree, of any length; 0: none
  vec2 uv;
  uint material;
  uint light;     // kNoLight: none; kLightTurned
};

Details load_details(uint slot, vec3 weights) {
  uint at = slot * (1u + 2u * kDetailNormals + 2u * kDetailUvs);
  uvec4 t0 = FETCH(detail_texels, at);
  Details d;
  d.light = t0.x;
  d.material = t0.w;
  d.normal = vec3(0.0);
  d.uv = vec2(0.0);
  if (kDetailNormals != 0u) {
    vec4 t1 = uintBitsToFloat(FETCH(detail_texels, at + 1u)), t2 = uintBitsToFloat(FETCH(detail_texels, at + 2u));
    d.normal = weights.x * t1.xyz + weights.y * t2.xyz + weights.z * vec3(t1.w, t2.w, uintBitsToFloat(t0.y));
  }
  if (kDetailUvs != 0u) {
    vec4 u = uintBitsToFloat(FETCH(detail_texels, at + 1u + 2u * kDetailNormals));
    vec2 v = uintBitsToFloat(FETCH(detail_texels, at + 2u + 2u * kDetailNormals).xy);
    d.uv = weights.x * u.xy + weights.y * u.zw + weights.z * v;
  }
  return d;
}
