// Lights (docs/direct.md): eight texels each: kind, flags, first primitive and number of further ones; radiance and area; position
// and radius; axis u and the hole's radius; axis v and the first triangle's place; normal and number of triangles; the dual vectors
// of the axes. A triangle has three: its corners, with the cumulative area as 0.32 fixed point of the light's, and its number in the
// mesh. Environments hold the rows of world-to-map instead of position and axes, and their map's place behind the third. The fourth
// word of a light's seventh texel is where its part of all power ends, as 0.32 fixed point (host/shading/virtual_light.h).
DATA_TEXELS(kBindLights, light_texels);
layout(constant_id = kSpecLightKinds) const uint kLightKinds = 0u;  // a bit a kind of the scene
bool has_light(uint kind) { return (kLightKinds & (1u << kind)) != 0u; }

struct Light {
  uint kind, flags, first_primitive, more_primitives;
  vec3 radiance;
  float area;
  vec3 position;
  float radius;
  vec3 axis_u;
  float inner;
  vec3 axis_v;
  uint place;  // of triangles, or of an environment's map
  vec3 normal;
  uint triangles;
};

Light load_light(uint index) {
  uvec4 t0 = FETCH(light_texels, index * 8u), t4 = FETCH(light_texels, index * 8u + 4u), t5 = FETCH(light_texels, index * 8u + 5u);
  vec4 t1 = uintBitsToFloat(FETCH(light_texels, index * 8u + 1u));
  vec4 t2 = uintBitsToFloat(FETCH(light_texels, index * 8u + 2u));
  vec4 t3 = uintBitsToFloat(FETCH(light_texels, index * 8u + 3u));
  return Light(t0.x, t0.y, t0.z, t0.w, t1.xyz, t1.w, t2.xyz, t2.w, t3.xyz, t3.w, uintBitsToFloat(t4.xyz), t4.w,
               uintBitsToFloat(t5.xyz), t5.w);
}

// A direction to a light.
struct LightSample {
  vec3 w;         // unit
  float t;        // distance; 3e38: beyond everything
  vec3 radiance;  // what comes from there if nothing is between; for point and distant lights over a density of 1
  float pdf;      // per solid angle; 0: nothing comes
  uint primitive, more_primitives;  // the light's own
};

vec3 to_map(Light l, vec3 w) { return vec3(dot(l.position, w), dot(l.axis_u, w), dot(l.axis_v, w)); }
vec3 from_map(Light l, vec3 d) { return d.x * l.position + d.y * l.axis_u + d.z * l.axis_v; }

// 1 - cos of half the angle under which a sphere is seen from outside.
float cone_depth(float radius, float distance2) {
  float sin2 = min(radius * radius / distance2, 1.0);
  return sin2 / (1.0 + sqrt(1.0 - sin2));
}

bool shines(Light l, bool front) { return front || (l.flags & kLightTwoSided) != 0u; }

LightSample towards(Light l, vec3 from, vec3 point, vec3 normal, float area) {
  LightSample s;
  vec3 d = point - from;
  float t2 = dot(d, d);
  s.t = sqrt(t2);
  s.w = d / max(s.t, 1e-30);
  float cosine = -dot(s.w, normal);
  s.radiance = shines(l, cosine > 0.0) ? l.radiance : vec3(0.0);
  s.pdf = cosine != 0.0 && t2 > 0.0 ? t2 / (area * abs(cosine)) : 0.0;
  s.primitive = l.first_primitive;
  s.more_primitives = l.more_primitives;
  return s;
}

vec3 point_of_disk(Light l, vec2 u) {
  vec2 d = concentric_disk(u);
  float r2 = dot(d, d);
  float h2 = l.inner * l.inner;
  d *= h2 > 0.0 ? sqrt(h2 / max(r2, 1e-30) + (1.0 - h2)) : 1.0;
  d = h2 > 0.0 && r2 == 0.0 ? vec2(l.inner, 0.0) : d;  // the centre has no direction
  return l.position + d.x * l.axis_u + d.y * l.axis_v;
}

LightSample sample_disk(Light l, vec3 from, vec2 u) { return towards(l, from, point_of_disk(l, u), l.normal, l.area); }

// A direction, uniform over the sphere.
vec3 sphere_of_directions(vec2 u) {
  float z = 1.0 - 2.0 * u.y;
  return vec3(sqrt(max(0.0, 1.0 - z * z)) * cos_sin_turn(u.x), z);
}

LightSample sample_sphere(Light l, vec3 from, vec2 u) {
  vec3 to_centre = l.position - from;
  float d2 = dot(to_centre, to_centre);
  float r2 = l.radius * l.radius;
  bool outside = d2 > r2;
  bool inward = (l.flags & kLightInward) != 0u;
  // From outside: the cone of directions.
  float c = cone_depth(l.radius, max(d2, r2));
  vec2 d = concentric_disk(u);
  float q = dot(d, d) * c;
  float far = sqrt(d2);
  LightSample s;
  s.w = normalize(to_frame(vec3(d * sqrt(max(0.0, c * (2.0 - q))), 1.0 - q), outside ? to_centre / far : vec3(0.0, 0.0, 1.0)));
  // The nearer point: distance to the foot of the centre less half the chord.
  float sin2 = q * (2.0 - q);
  s.t = far * (1.0 - q) - sqrt(max(0.0, r2 - d2 * sin2));
  s.pdf = 1.0 / (6.283185307179586 * c);
  s.radiance = shines(l, !inward) ? l.radiance : vec3(0.0);
  s.primitive = l.first_primitive;
  s.more_primitives = l.more_primitives;
  // From inside: any of its points.
  vec3 n = sphere_of_directions(u);
  LightSample within = towards(l, from, l.position + l.radius * n, n, l.area);
  within.radiance = shines(l, inward) ? l.radiance : vec3(0.0);
  s.w = outside ? s.w : within.w;
  s.t = outside ? s.t : within.t;
  s.pdf = outside ? s.pdf : within.pdf;
  s.radiance = outside ? s.radiance : within.radiance;
  return s;
}

struct TrianglePoint {
  vec3 at;
  vec3 cross_product;  // of two edges: along the emitting side's normal, of any length
  uint number;         // of the triangle in its mesh
};

TrianglePoint point_of_triangles(Light l, uvec2 bits) {
  // The first triangle whose cumulative area is above x of the whole.
  uint value = bits.x & 0xffffff00u;
  uint low = 0u, high = l.triangles - 1u;
  bool going = low < high;
  while (going) {
    uint middle = (low + high) >> 1u;
    bool above = FETCH(light_texels, l.place + middle * 3u).w > value;
    high = going && above ? middle : high;
    low = going && !above ? middle + 1u : low;
    going = low < high;
  }
  uvec4 t0 = FETCH(light_texels, l.place + low * 3u);
  uvec4 t1 = FETCH(light_texels, l.place + low * 3u + 1u);
  vec3 a = uintBitsToFloat(t0.xyz), b = uintBitsToFloat(t1.xyz), c = uintBitsToFloat(FETCH(light_texels, l.place + low * 3u + 2u).xyz);
  uint before = low == 0u ? 0u : FETCH(light_texels, l.place + (max(low, 1u) - 1u) * 3u).w;
  float x = float(value - before) / float(max(t0.w - before, 1u)), y = unit_floats(bits).y;
  bool upper = y > x;
  vec2 p = upper ? vec2(0.5 * x, y - 0.5 * x) : vec2(x - 0.5 * y, 0.5 * y);
  return TrianglePoint(a + p.x * (b - a) + p.y * (c - a), cross(b - a, c - a), t1.w);
}

LightSample sample_triangles(Light l, vec3 from, uvec2 bits) {
  TrianglePoint point = point_of_triangles(l, bits);
  LightSample s = towards(l, from, point.at, normalize(point.cross_product), l.area);
  // An ellipsoid emits as triangles inside it: it does not hide those that show their outer side. What is hidden has no primitives.
  bool quadric = (l.first_primitive & kQuadricBit) != 0u;
  float along = dot(s.w, point.cross_product);
  bool inner_side = (l.flags & kLightInward) != 0u ? along <= 0.0 : along >= 0.0;
  bool hidden = l.first_primitive == kNoPrimitive;
  s.primitive = hidden || (quadric && inner_side) ? kNoPrimitive : l.first_primitive + point.number;
  s.more_primitives = 0u;
  return s;
}

// By the point of the light's dimension pair. `ng`: normal of the surface, for constant environments. kKind is a constant.
LightSample sample_light(const uint kind, Light l, vec3 from, vec3 ng, uvec2 bits) {
  vec2 u = unit_floats(bits);
  if (kind == kLightDisk) return sample_disk(l, from, u);
  if (kind == kLightSphere) return sample_sphere(l, from, u);
  if (kind == kLightRectangle) return towards(l, from, l.position + u.x * l.axis_u + u.y * l.axis_v, l.normal, l.area);
  if (kind == kLightTriangles) return sample_triangles(l, from, bits);
  LightSample s = LightSample(vec3(0.0, 0.0, 1.0), 3e38, l.radiance, 1.0, kNoPrimitive, 0u);
  if (kind == kLightMap) {
    Map m = load_map(l.place);
    vec4 d = sample_map(m, bits);
    s.w = normalize(from_map(l, d.xyz));
    s.radiance = l.radiance * map_value(m, map_square(m, d.xyz));
    s.pdf = d.w;
  }
  if (kind == kLightConstant) {
    vec3 local = cosine_hemisphere(u);
    s.w = normalize(to_frame(local, ng));
    s.pdf = local.z * 0.3183098861837907;
  }
  if (kind == kLightDistant) s.w = -l.normal;
  if (kind == kLightPoint) {
    vec3 d = l.position - from;
    float t2 = dot(d, d);
    s.t = sqrt(t2);
    s.w = d / max(s.t, 1e-30);
    s.radiance = l.radiance / max(t2, 1e-37);
    s.pdf = t2 > 0.0 ? 1.0 : 0.0;
  }
  return s;
}

// What a ray meets of an area light that is no mesh: its distance or -1; radiance and density as if the ray had been sampled.
float meet_light(Light l, Ray ray, out vec3 radiance, out float pdf) {
  float t = -1.0;
  radiance = vec3(0.0);
  pdf = 0.0;
  if (has_light(kLightDisk) || has_light(kLightSphere)) {
    bool quadric = l.kind == kLightDisk || l.kind == kLightSphere;
    bool there = quadric && (l.flags & kLightHidden) == 0u;  // no ray meets a hidden one
    float at = meet_quadric(ray, there ? l.first_primitive & ~kQuadricBit : 0u, 0.0);
    t = quadric ? at : t;
  }
  if (has_light(kLightRectangle)) {
    float down = dot(ray.direction, l.normal);
    float at = dot(l.position - ray.origin, l.normal) / (down == 0.0 ? 1e-30 : down);
    vec3 p = ray.origin + at * ray.direction - l.position;
    vec3 dual_u = uintBitsToFloat(FETCH(light_texels, l.place).xyz), dual_v = uintBitsToFloat(FETCH(light_texels, l.place + 1u).xyz);
    float x = dot(p, dual_u), y = dot(p, dual_v);
    bool met = at > 0.0 && x >= 0.0 && x <= 1.0 && y >= 0.0 && y <= 1.0;
    t = l.kind == kLightRectangle ? (met ? at : -1.0) : t;
  }
  bool front = dot(ray.direction, l.normal) < 0.0;
  float cosine = abs(dot(ray.direction, l.normal));
  if (has_light(kLightSphere)) {
    vec3 d = l.position - ray.origin;
    float d2 = dot(d, d), r2 = l.radius * l.radius;
    bool outside = d2 > r2;
    bool sphere = l.kind == kLightSphere;
    vec3 n = normalize(ray.origin + t * ray.direction - l.position);
    front = sphere ? outside != ((l.flags & kLightInward) != 0u) : front;
    cosine = sphere ? abs(dot(n, ray.direction)) : cosine;
    pdf = sphere && outside ? 1.0 / (6.283185307179586 * cone_depth(l.radius, d2)) : 0.0;
  }
  pdf = pdf > 0.0 ? pdf : t * t / (l.area * max(cosine, 1e-30));
  radiance = shines(l, front) ? l.radiance : vec3(0.0);
  return t;
}

// An environment towards w.
vec3 environment_towards(Light l, vec3 w, vec3 ng, out float pdf) {
  vec3 radiance = l.radiance;
  pdf = max(dot(w, ng), 0.0) * 0.3183098861837907;
  if (has_light(kLightMap)) {
    bool mapped = l.kind == kLightMap;
    Map m = load_map(mapped ? l.place : 0u);
    vec2 square = map_square(m, to_map(l, w));
    radiance = mapped ? radiance * map_value(m, square) : radiance;
    pdf = mapped ? map_pdf(m, square) : pdf;
  }
  return radiance;
}
