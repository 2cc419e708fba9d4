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

uint details_place(uint slot) { return slot * (1u + 2u * kDetailNormals + 2u * kDetailUvs); }

// Of the vertices, unit vectors in the space of the primitive's tree; 0: none.
mat3 load_normals(uint slot) {
  uint at = details_place(slot);
  vec4 t1 = uintBitsToFloat(FETCH(detail_texels, at + 1u)), t2 = uintBitsToFloat(FETCH(detail_texels, at + 2u));
  return mat3(t1.xyz, t2.xyz, vec3(t1.w, t2.w, uintBitsToFloat(FETCH(detail_texels, at).y)));
}

vec3 weighted(mat3 m, vec3 weights) { return weights.x * m[0] + weights.y * m[1] + weights.z * m[2]; }

Details load_details(uint slot, vec3 weights) {
  uint at = details_place(slot);
  uvec4 t0 = FETCH(detail_texels, at);
  Details d;
  d.light = t0.x;
  d.material = t0.w;
  d.normal = vec3(0.0);
  d.uv = vec2(0.0);
  if (kDetailNormals != 0u) d.normal = weighted(load_normals(slot), weights);
  if (kDetailUvs != 0u) {
    vec4 u = uintBitsToFloat(FETCH(detail_texels, at + 1u + 2u * kDetailNormals));
    vec2 v = uintBitsToFloat(FETCH(detail_texels, at + 2u + 2u * kDetailNormals).xy);
    d.uv = weights.x * u.xy + weights.y * u.zw + weights.z * v;
  }
  return d;
}
