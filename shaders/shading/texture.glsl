// Textures of base colours: three header texels among the materials (pixels' place, width, height, wrap; scale and offset; factor;
// average), and a texel a pixel, as host/shading/texture.h's texel() gives it.
DATA_TEXELS(kBindTextures, texture_texels);

vec3 texture_pixel(uvec4 header, ivec2 p) {
  ivec2 size = ivec2(header.yz);
  bool inside = p.x >= 0 && p.x < size.x && p.y >= 0 && p.y < size.y;
  ivec2 repeated = p - size * ivec2(floor(vec2(p) / vec2(size)));
  repeated = clamp(repeated, ivec2(0), size - 1);  // the quotient may round
  ivec2 q = header.w == kWrapRepeat ? repeated : clamp(p, ivec2(0), size - 1);
  vec3 value = uintBitsToFloat(FETCH(texture_texels, header.x + uint(q.y) * header.y + uint(q.x)).xyz);
  return header.w == kWrapBlack && !inside ? vec3(0.0) : value;
}

// Bilinear between texel centres, v = 0 at the image's lower edge.
vec3 texture_value(uint texture_at, vec2 uv) {
  uvec4 header = FETCH(material_texels, texture_at);
  vec4 placing = uintBitsToFloat(FETCH(material_texels, texture_at + 1u));
  vec3 factor = uintBitsToFloat(FETCH(material_texels, texture_at + 2u).xyz);
  vec3 average = uintBitsToFloat(FETCH(material_texels, texture_at + 3u).xyz);
  vec2 st = placing.xy * uv + placing.zw;
  vec2 at = vec2(st.x, 1.0 - st.y) * vec2(header.yz) - 0.5;
  bool usable = abs(at.x) < 1e9 && abs(at.y) < 1e9;  // not for NaN
  at = usable ? at : vec2(0.0);
  vec2 corner = floor(at);
  vec2 t = at - corner;
  ivec2 p = ivec2(corner);
  vec3 lower = mix(texture_pixel(header, p), texture_pixel(header, p + ivec2(1, 0)), t.x);
  vec3 upper = mix(texture_pixel(header, p + ivec2(0, 1)), texture_pixel(header, p + ivec2(1, 1)), t.x);
  return usable ? factor * mix(lower, upper, t.y) : average;
}
