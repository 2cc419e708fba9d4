// A measured BRDF's table (host/shading/measured_brdf.h): 64 x 64 x 32 texels over theta_h (square root), theta_d and phi_d.

vec3 measured_value(uint table, vec3 i, vec3 o) {
  vec3 h = normalize(i + o);
  float ring = sqrt(h.x * h.x + h.y * h.y);
  vec2 azimuth = ring > 0.0 ? h.xy / ring : vec2(1.0, 0.0);
  float x = dot(i, vec3(h.z * azimuth, -ring));
  float y = dot(i, vec3(-azimuth.y, azimuth.x, 0.0));
  const float kScale = 0.6366197723675814;  // 2 / pi
  float half_angle = angle_in_quadrant(ring, h.z) * kScale;
  float difference = angle_in_quadrant(sqrt(x * x + y * y), max(dot(i, h), 0.0)) * kScale;
  float turn = angle_in_quadrant(abs(y), abs(x)) * kScale;
  vec3 at = vec3(sqrt(half_angle) * 63.0, difference * 63.0, turn * 31.0);
  vec3 cell = clamp(floor(at), vec3(0.0), vec3(62.0, 62.0, 30.0));
  vec3 t = clamp(at - cell, vec3(0.0), vec3(1.0));
  uint first = table + (uint(cell.x) * 64u + uint(cell.y)) * 32u + uint(cell.z);
  vec3 sum = vec3(0.0);
  for (uint corner = 0u; corner < 8u; ++corner) {
    uvec3 far = uvec3(corner & 1u, (corner >> 1u) & 1u, corner >> 2u);
    vec3 w = mix(vec3(1.0) - t, t, equal(far, uvec3(1u)));
    vec3 value = uintBitsToFloat(FETCH(material_texels, first + far.x * 2048u + far.y * 32u + far.z).xyz);
    sum += w.x * w.y * w.z * value;
  }
  return sum;
}
