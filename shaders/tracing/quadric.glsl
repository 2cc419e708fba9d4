// Spheres and disks in their own space: seven texels each, rows of world-to-object and object-to-world, then kind and the
// square of a disk's inner radius (of the unit disk).
layout(constant_id = kSpecQuadrics) const uint kHasQuadrics = 0u;
DATA_TEXELS(kBindQuadrics, quadric_texels);

vec4 quadric_row(uint quadric, uint row) { return uintBitsToFloat(FETCH(quadric_texels, quadric * 7u + row)); }

vec3 quadric_point(uint q, uint row, vec3 p) {
  vec4 h = vec4(p, 1.0);
  return vec3(dot(quadric_row(q, row), h), dot(quadric_row(q, row + 1u), h), dot(quadric_row(q, row + 2u), h));
}

vec3 quadric_vector(uint q, uint row, vec3 v) {
  return vec3(dot(quadric_row(q, row).xyz, v), dot(quadric_row(q, row + 1u).xyz, v), dot(quadric_row(q, row + 2u).xyz, v));
}

// Distance of the first hit beyond `t_min`, or -1.
float meet_quadric(Ray ray, uint q, float t_min) {
  vec3 o = quadric_point(q, 0u, ray.origin);
  vec3 d = quadric_vector(q, 0u, ray.direction);
  uvec4 last = FETCH(quadric_texels, q * 7u + 6u);
  // Disk in z = 0.
  float t_disk = -o.z / (d.z == 0.0 ? 1e-30 : d.z);
  vec2 p = o.xy + t_disk * d.xy;
  float r2 = dot(p, p);
  bool on_disk = r2 <= 1.0 && r2 >= uintBitsToFloat(last.y) && t_disk > t_min;
  // Unit sphere: from the point of the ray nearest to the centre, which keeps digits when it is far away.
  float dd = dot(d, d);
  float nearest = -dot(o, d) / dd;
  vec3 l = o + nearest * d;
  float under = 1.0 - dot(l, l);
  float half_chord = sqrt(max(under, 0.0) / dd);
  float t_sphere = nearest - half_chord > t_min ? nearest - half_chord : nearest + half_chord;
  bool on_sphere = under >= 0.0 && t_sphere > t_min;
  bool disk = last.x == kQuadricDisk;
  bool hit = disk ? on_disk : on_sphere;
  return hit ? (disk ? t_disk : t_sphere) : -1.0;
}
