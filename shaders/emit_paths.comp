#version 460
#extension GL_GOOGLE_include_directive : require
// Where light paths start (docs/igi.md): a light chosen by power, a point on it, a direction. One path a thread. Reads lights and the
// sampler's table; writes three texels a path.
#include "layout.h"

layout(local_size_x = kGroupSize) in;
#include "shading/paths.glsl"
#include "tracing/off_surface.glsl"

struct Start {
  vec3 origin;
  vec3 direction;
  vec3 flux;      // times the probability of its light
  uint primitive, more_primitives;  // not met by its ray
};

const float kPi = 3.141592653589793;

Start from_area(Light l, uvec2 u, uvec2 v, float side) {
  vec3 at = vec3(0.0), n = l.normal;
  uint first = l.first_primitive, more = l.more_primitives;
  if (has_light(kLightDisk)) at = l.kind == kLightDisk ? point_of_disk(l, unit_floats(u)) : at;
  if (has_light(kLightRectangle)) {
    vec2 p = unit_floats(u);
    at = l.kind == kLightRectangle ? l.position + p.x * l.axis_u + p.y * l.axis_v : at;
  }
  if (has_light(kLightTriangles)) {
    if (l.kind == kLightTriangles) {
      TrianglePoint p = point_of_triangles(l, u);
      at = p.at;
      n = normalize(p.cross_product);
      first += (l.first_primitive & kQuadricBit) == 0u ? p.number : 0u;
      more = 0u;
    }
  }
  bool inward = (l.flags & kLightInward) != 0u;
  if (has_light(kLightSphere)) {
    vec3 out_of = sphere_of_directions(unit_floats(u));
    bool sphere = l.kind == kLightSphere;
    at = sphere ? l.position + l.radius * out_of : at;
    n = sphere ? (inward ? -out_of : out_of) : n;
  }
  bool two_sided = (l.flags & kLightTwoSided) != 0u;
  bool back = two_sided && side >= 0.5;
  n = back ? -n : n;
  // What is round and shines inwards is met again by its own light.
  bool round_inside = (first & kQuadricBit) != 0u && l.kind != kLightDisk && inward != back;
  bool hidden = (l.flags & kLightHidden) != 0u || l.first_primitive == kNoPrimitive;
  Start s;
  s.origin = off_surface(at, n, 1.0e-6 * (abs(at) + abs(l.position)));
  s.direction = normalize(to_frame(cosine_hemisphere(unit_floats(v)), n));
  s.flux = l.radiance * (l.area * kPi * (two_sided ? 2.0 : 1.0));
  s.primitive = round_inside || hidden ? kNoPrimitive : first;
  s.more_primitives = round_inside || hidden ? 0u : more;
  return s;
}

// Environments, distant and point lights.
Start from_afar(Light l, uvec2 u, uvec2 v) {
  vec3 w = -l.normal;
  float density = 1.0;  // of w
  vec3 radiance = l.radiance;
  vec3 around = sphere_of_directions(unit_floats(v));
  bool constant = l.kind == kLightConstant, point = l.kind == kLightPoint;
  w = constant || point ? around : w;
  density = constant || point ? 0.25 / kPi : density;
  if (has_light(kLightMap)) {
    if (l.kind == kLightMap) {
      Map m = load_map(l.place);
      vec4 d = sample_map(m, v);
      w = normalize(from_map(l, d.xyz));
      radiance *= map_value(m, map_square(m, d.xyz));
      density = d.w;
    }
  }
  float radius = push.bounds.w;
  vec2 d = concentric_disk(unit_floats(u));
  Start s;
  s.origin = point ? l.position : push.bounds.xyz + radius * to_frame(vec3(d, 1.0), w);
  s.direction = point ? w : -w;
  s.flux = radiance * ((point ? 1.0 : kPi * radius * radius) / max(density, 1e-37));
  s.flux = density > 0.0 ? s.flux : vec3(0.0);
  s.primitive = kNoPrimitive;
  s.more_primitives = 0u;
  return s;
}

uint end_of(uint light) { return FETCH(light_texels, light * 8u + 6u).w; }

void main() {
  uint path = push.first + gl_GlobalInvocationID.x;
  bool live = gl_GlobalInvocationID.x < push.batch;
  uint set = (live ? path : 0u) / max(push.split.y, 1u);
  uint index = (live ? path : 0u) - set * push.split.y;
  bool several = push.lights > 1u;
  uint kind = FETCH(light_texels, 0u).x;
  uint place_domain = several || kind == kLightRectangle || kind == kLightTriangles ? kDomainSquare
                      : kind == kLightSphere                                        ? kDomainCylinder
                                                                                    : kDomainDisk;
  uint turn_domain = several ? kDomainSquare : kind <= kLightTriangles ? kDomainDisk : kDomainCylinder;
  uvec2 u = path_bits(set, index, 0u, kPairOrigin, place_domain);
  uvec2 v = path_bits(set, index, 0u, kPairEmission, turn_domain);
  float side = path_choice(set, index, 0u);

  // The first light whose part ends above u.x.
  uint low = 0u, high = max(push.lights, 1u) - 1u;
  bool going = low < high;
  while (going) {
    uint middle = (low + high) >> 1u;
    bool above = end_of(middle) > u.x;
    high = going && above ? middle : high;
    low = going && !above ? middle + 1u : low;
    going = low < high;
  }
  uint before = low == 0u ? 0u : end_of(max(low, 1u) - 1u);
  bool last = low + 1u >= push.lights;
  uint part = last ? 0u - before : end_of(low) - before;  // 0: all of 2^32
  float share = part == 0u ? 1.0 : float(part) * 2.3283064365386963e-10;
  float stretched = min(float(u.x - before) / float(part), 0.99999994);
  u.x = several ? uint(stretched * 16777216.0) << 8u : u.x;

  Light l = load_light(low);
  Start s = from_area(l, u, v, side);
  Start t = from_afar(l, u, v);
  bool area = l.kind <= kLightTriangles;
  vec3 flux = (area ? s.flux : t.flux) / (share * float(max(push.split.y, 1u)));
  if (live) {
    paths[path * 3u] = uvec4(floatBitsToUint(area ? s.origin : t.origin), kNoPrimitive);
    paths[path * 3u + 1u] = uvec4(floatBitsToUint(area ? s.direction : t.direction), area ? s.primitive : t.primitive);
    paths[path * 3u + 2u] = uvec4(floatBitsToUint(flux), area ? s.more_primitives : t.more_primitives);
  }
}
