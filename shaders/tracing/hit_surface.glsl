// The surface where a ray met it, ready for rays that leave it. With kDetails also what shading needs of it.
layout(constant_id = kSpecDetails) const uint kDetails = 0u;
#include "tracing/details.glsl"
#include "tracing/off_surface.glsl"

struct HitSurface {
  vec3 origin;      // off the surface, on the side that the ray came from
  vec3 normal;      // geometric, unit, on that side
  uint primitive;   // its id, which rays that leave it do not meet, or kNoPrimitive
  bool front;       // the side on which the vertices are counter-clockwise was met
  bool seen;        // something was met that has a normal
  vec3 shading_normal;  // unit, on the same side
  Details details;
};

// A point, its normal and the bound of its error from an instance's object into the world. The way back into the object, when
// the ray that leaves here comes to it, rounds once more.
void to_world(uint instance, inout vec3 position, inout vec3 normal, inout vec3 error) {
  vec4 m0 = instance_row(instance, 5u), m1 = instance_row(instance, 6u), m2 = instance_row(instance, 7u);
  vec4 i0 = instance_row(instance, 0u), i1 = instance_row(instance, 1u), i2 = instance_row(instance, 2u);
  bool own = (FETCH(instance_texels, instance * 8u + 3u).w & kWorldInstance) != 0u;
  vec4 p = vec4(position, 1.0);
  vec3 q = vec3(dot(m0, p), dot(m1, p), dot(m2, p));
  vec4 ap = abs(p), aq = abs(vec4(q, 1.0));
  vec3 back = error + 3.0e-7 * vec3(dot(abs(i0), aq), dot(abs(i1), aq), dot(abs(i2), aq));
  vec3 e = vec3(dot(abs(m0.xyz), back), dot(abs(m1.xyz), back), dot(abs(m2.xyz), back)) +
           3.0e-7 * vec3(dot(abs(m0), ap), dot(abs(m1), ap), dot(abs(m2), ap));
  vec3 n = normalize(normal.x * i0.xyz + normal.y * i1.xyz + normal.z * i2.xyz);
  position = own ? position : q;
  normal = own ? normal : n;
  error = own ? error : e;
}

// The mesh's normal, unit and on the side of `facing`, or that itself.
vec3 shading_normal_of(Hit hit, uint slot, vec3 n, vec3 facing) {
  if (kInstances != 0u && kDetailNormals != 0u) {
    // Each vertex's is made a unit vector in the world before they are weighed.
    bool own = (FETCH(instance_texels, hit.instance * 8u + 3u).w & kWorldInstance) != 0u;
    mat3 to_world = mat3(instance_row(hit.instance, 0u).xyz, instance_row(hit.instance, 1u).xyz, instance_row(hit.instance, 2u).xyz);
    mat3 world = to_world * load_normals(slot);
    for (int k = 0; k < 3; ++k) world[k] *= inversesqrt(max(dot(world[k], world[k]), 1e-37));
    n = own ? n : weighted(world, hit.weights);
  }
  float length2 = dot(n, n);
  n = length2 > 0.0 ? n * inversesqrt(length2) : facing;
  return dot(n, facing) < 0.0 ? -n : n;
}

HitSurface surface_at(Ray ray, Hit hit, bool live) {
  uint slot = hit.slot == kNoPrimitive ? 0u : hit.slot;
  uvec4 w0 = FETCH(primitive_texels, slot * 3u);
  vec3 p0 = uintBitsToFloat(w0.xyz);
  vec3 p1 = uintBitsToFloat(FETCH(primitive_texels, slot * 3u + 1u).xyz);
  vec3 p2 = uintBitsToFloat(FETCH(primitive_texels, slot * 3u + 2u).xyz);
  vec3 q0 = hit.weights.x * p0, q1 = hit.weights.y * p1, q2 = hit.weights.z * p2;
  vec3 position = q0 + q1 + q2;
  vec3 error = 7.0 * 6.0e-8 * (abs(q0) + abs(q1) + abs(q2));  // gamma(7), Pharr et al. 2016, section 3.9
  vec3 normal = normalize(cross(p1 - p0, p2 - p0));
  if (kHasQuadrics != 0u && (w0.w & kQuadricBit) != 0u) {
    uint q = w0.w & ~kQuadricBit;
    vec3 o = quadric_point(q, 0u, ray.origin + hit.t * ray.direction);
    bool disk = FETCH(quadric_texels, q * 7u + 6u).x == kQuadricDisk;
    o = disk ? vec3(o.xy, 0.0) : normalize(o);
    position = quadric_point(q, 3u, o);
    vec3 n = disk ? vec3(0.0, 0.0, 1.0) : o;
    normal = normalize(quadric_row(q, 0u).xyz * n.x + quadric_row(q, 1u).xyz * n.y + quadric_row(q, 2u).xyz * n.z);
    vec3 middle = vec3(quadric_row(q, 3u).w, quadric_row(q, 4u).w, quadric_row(q, 5u).w);
    error = 1.0e-6 * (abs(position - middle) + abs(middle));
  }
  if (kInstances != 0u) to_world(hit.instance, position, normal, error);
  HitSurface s;
  s.front = dot(normal, ray.direction) < 0.0;
  s.normal = s.front ? normal : -normal;
  s.origin = off_surface(position, s.normal, error);
  // A degenerate triangle has no normal: as if nothing were seen rather than spreading NaN.
  s.seen = live && hit.slot != kNoPrimitive && dot(normal, normal) > 0.5;
  // A sphere seen from inside can be met again by a ray that leaves it.
  bool sphere = kHasQuadrics != 0u && (w0.w & kQuadricBit) != 0u && FETCH(quadric_texels, (w0.w & ~kQuadricBit) * 7u + 6u).x == kQuadricSphere;
  s.primitive = s.seen && !sphere ? hit_id(hit) : kNoPrimitive;
  s.shading_normal = s.normal;
  if (kDetails != 0u) {
    uint detail_slot = s.seen ? hit.slot : 0u;
    s.details = load_details(detail_slot, hit.weights);
    s.shading_normal = shading_normal_of(hit, detail_slot, s.details.normal, s.normal);
  }
  return s;
}
