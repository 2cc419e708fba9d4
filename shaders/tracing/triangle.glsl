// Watertight triangles: vertices are projected along the ray onto two axes that depend on the ray alone, so that an edge
// shared by two triangles gives the same products in both, and a ray through it meets at least one (after Woop, Benthin
// and Wald, JCGT 2(1), 2013; zero counts as inside). `precise` forbids fused multiply-adds, which would break the symmetry.
struct RayFrame {
  vec3 u;
  vec3 v;
};

RayFrame ray_frame(vec3 d) {
  float s = d.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (s + d.z);
  float b = d.x * d.y * a;
  RayFrame f;
  f.u = vec3(1.0 + s * d.x * d.x * a, s * b, -s * d.x);
  f.v = vec3(b, s + d.y * d.y * a, -d.y);
  return f;
}

// The ray's distance to the plane of a triangle that it meets, in x; weights of the vertices in yzw; x < 0: no hit.
vec4 meet_triangle(Ray ray, RayFrame f, vec3 p0, vec3 p1, vec3 p2) {
  precise vec3 a = p0 - ray.origin;
  precise vec3 b = p1 - ray.origin;
  precise vec3 c = p2 - ray.origin;
  precise float ax = a.x * f.u.x + a.y * f.u.y + a.z * f.u.z;
  precise float bx = b.x * f.u.x + b.y * f.u.y + b.z * f.u.z;
  precise float cx = c.x * f.u.x + c.y * f.u.y + c.z * f.u.z;
  precise float ay = a.x * f.v.x + a.y * f.v.y + a.z * f.v.z;
  precise float by = b.x * f.v.x + b.y * f.v.y + b.z * f.v.z;
  precise float cy = c.x * f.v.x + c.y * f.v.y + c.z * f.v.z;
  precise float wa = cx * by - cy * bx;
  precise float wb = ax * cy - ay * cx;
  precise float wc = bx * ay - by * ax;
  // Not min() and max(): those take three instructions each for the sake of NaN.
  float low = wb < wc ? wb : wc;
  low = wa < low ? wa : low;
  float high = wb > wc ? wb : wc;
  high = wa > high ? wa : high;
  float sum = wa + wb + wc;
  float az = dot(a, ray.direction);
  float bz = dot(b, ray.direction);
  float cz = dot(c, ray.direction);
  float scale = 1.0 / sum;
  float t = (wa * az + wb * bz + wc * cz) * scale;
  // A distance within its own rounding is none: a ray that starts in the triangle's plane, where another one lies, leaves it.
  float rounding = 1.5e-7 * (abs(az) + abs(bz) + abs(cz));
  bool hit = (low >= 0.0 || high <= 0.0) && sum != 0.0 && t > rounding;
  return vec4(hit ? t : -1.0, vec3(wa, wb, wc) * scale);
}
