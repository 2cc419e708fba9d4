// Where a 2D point goes. Sines and cosines are polynomials: GLSL's own may be off by 2^-11, and differ between devices.

// sin and cos for |x| <= pi/4, error below 1e-7: Taylor to x^9 and x^10.
vec2 cos_sin_octant(float x) {
  float x2 = x * x;
  float c = 1.0 + x2 * (-0.5 + x2 * (1.0 / 24.0 + x2 * (-1.0 / 720.0 + x2 * (1.0 / 40320.0))));
  float s = x * (1.0 + x2 * (-1.0 / 6.0 + x2 * (1.0 / 120.0 + x2 * (-1.0 / 5040.0 + x2 * (1.0 / 362880.0)))));
  return vec2(c, s);
}

// The concentric map of the unit square to the unit disk, Shirley and Chiu 1997: areas keep their ratio.
vec2 concentric_disk(vec2 u) {
  vec2 p = 2.0 * u - 1.0;
  bool wide = abs(p.x) > abs(p.y);
  float radius = wide ? p.x : p.y;
  float other = wide ? p.y : p.x;
  float ratio = radius == 0.0 ? 0.0 : other / radius;
  vec2 cs = cos_sin_octant(0.785398163397448 * ratio);
  return radius * (wide ? cs : cs.yx);
}

// A direction about +z with density cos(theta) / pi: the disk lifted onto the hemisphere (Malley).
vec3 cosine_hemisphere(vec2 u) {
  vec2 d = concentric_disk(u);
  return vec3(d, sqrt(max(0.0, 1.0 - dot(d, d))));
}

// The tangents of Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
void tangents(vec3 n, out vec3 t, out vec3 bt) {
  float s = n.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (s + n.z);
  float b = n.x * n.y * a;
  t = vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x);
  bt = vec3(b, s + n.y * n.y * a, -n.y);
}

vec3 to_frame(vec3 v, vec3 n) {
  vec3 t, bt;
  tangents(n, t, bt);
  return v.x * t + v.y * bt + v.z * n;
}

// And back.
vec3 from_frame(vec3 w, vec3 n) {
  vec3 t, bt;
  tangents(n, t, bt);
  return vec3(dot(w, t), dot(w, bt), dot(w, n));
}
