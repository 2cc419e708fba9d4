// What a pixel sees, as shading needs it: written by primary.comp; or surfaces that rays met, seen from where those came from.
layout(constant_id = kSpecReceivers) const uint kReceivers = 0u;
DATA_TEXELS(kBindSurfaces, surface_texels);
DATA_TEXELS(kBindShading, shading_texels);

struct Surface {
  vec3 origin;     // for rays that leave it
  uint primitive;  // its id, which such rays do not meet
  vec3 ng;         // geometric normal, faces the viewer
  vec3 ns;         // shading normal on that side
  vec3 wo;         // to the viewer
  vec2 uv;
  uint material;
  bool live;
  uint pixel, index;  // of a surface that a ray met: what its random numbers are addressed by
};

// `place`: pixel of the band. A pixel that sees nothing gives values that do no harm.
Surface load_surface(uint place, vec3 eye, bool inside) {
  uint stride = 2u + kReceivers;
  uvec4 at = FETCH(surface_texels, place * stride);
  uvec4 facing = FETCH(surface_texels, place * stride + 1u);
  uvec4 s0 = FETCH(shading_texels, place * 2u);
  uvec4 s1 = FETCH(shading_texels, place * 2u + 1u);
  Surface s;
  s.live = inside && facing.w != 0u;
  s.origin = uintBitsToFloat(at.xyz);
  s.primitive = at.w;
  s.ng = s.live ? uintBitsToFloat(facing.xyz) : vec3(0.0, 0.0, 1.0);
  vec3 wo = normalize(eye - s.origin);
  s.pixel = 0u;
  s.index = 0u;
  if (kReceivers != 0u) {
    uvec4 from = FETCH(surface_texels, place * stride + 2u);
    wo = uintBitsToFloat(from.xyz);
    s.pixel = from.w;
    s.index = facing.w - 1u;
  }
  s.wo = s.live ? wo : vec3(0.0, 0.0, 1.0);
  vec3 ns = uintBitsToFloat(s0.xyz);
  s.ns = s.live && dot(ns, s.wo) > 0.0 ? ns : s.ng;
  s.uv = uintBitsToFloat(s1.xy);
  s.material = s.live ? s0.w : 0u;
  return s;
}
