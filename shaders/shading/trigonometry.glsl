// Angles without GLSL's own functions, which may be off by 2^-11 and differ between devices. cos_sin_octant: sampling/warp.glsl.

// cos and sin of u turns, u in [0, 1].
vec2 cos_sin_turn(float u) {
  float quarter = floor(4.0 * u + 0.5);
  vec2 cs = cos_sin_octant((4.0 * u - quarter) * 1.5707963267948966);
  uint q = uint(quarter) & 3u;
  cs = (q & 1u) != 0u ? vec2(-cs.y, cs.x) : cs;
  return q >= 2u ? -cs : cs;
}

// Angle of (x, y) in the first quadrant, in [0, pi/2], error below 2e-7: polynomial of the Cephes library (Moshier 1989).
float angle_in_quadrant(float y, float x) {
  float low = min(x, y), high = max(x, y);
  float r = high > 0.0 ? low / high : 0.0;
  bool upper = r > 0.4142135623730950;
  r = upper ? (r - 1.0) / (r + 1.0) : r;
  float z = r * r;
  float a = (((8.05374449538e-2 * z - 1.38776856032e-1) * z + 1.99777106478e-1) * z - 3.33329491539e-1) * z * r + r;
  a += upper ? 0.7853981633974483 : 0.0;
  return y > x ? 1.5707963267948966 - a : a;
}

// Azimuth of (x, y) in turns, in [0, 1).
float turn_of(float y, float x) {
  float a = angle_in_quadrant(abs(y), abs(x)) * 0.15915494309189535;
  a = x < 0.0 ? 0.5 - a : a;
  a = y < 0.0 ? 1.0 - a : a;
  return a >= 1.0 ? 0.0 : a;
}
