#version 460
#extension GL_GOOGLE_include_directive : require
// What each pixel sees. Reads the tree and, for jittered image samples, the sampler's table; writes two texels a pixel: the
// origin for rays that leave the surface with the primitive's id, and the normal that faces the viewer (where nothing is seen: the
// ray's direction). One ray a thread.
#include "layout.h"

layout(local_size_x = kGroupSize) in;
layout(push_constant, std430) uniform Push { PrimaryConstants push; };
layout(constant_id = kSpecJittered) const uint kJittered = 0u;

#include "fetch.glsl"
#include "sampling/sampler.glsl"
#include "sampling/filter.glsl"
#include "tracing/bvh.glsl"

layout(set = 0, binding = kBindSurfaces, std430) writeonly buffer Surfaces { uvec4 surfaces[]; };

// What shading needs, where it is asked for: shading normal and material; uv, light and whether it shines this way.
layout(constant_id = kSpecDetails) const uint kDetails = 0u;
layout(set = 0, binding = kBindShading, std430) writeonly buffer Shading { uvec4 shading[]; };
#include "tracing/details.glsl"

// `facing`: the unit normal that faces the viewer; `front`: the side on which the vertices are counter-clockwise is seen.
void write_shading(uint place, Hit hit, vec3 facing, bool front, bool seen) {
  uint slot = seen ? hit.slot : 0u;
  Details d = load_details(slot, hit.weights);
  vec3 n = d.normal;
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
  n = dot(n, facing) < 0.0 ? -n : n;
  bool shines = front != ((d.light & kLightTurned) != 0u);
  shading[place * 2u] = uvec4(floatBitsToUint(n), d.material);
  shading[place * 2u + 1u] = uvec4(floatBitsToUint(d.uv), seen ? d.light & ~kLightTurned : kNoLight, shines ? 1u : 0u);
}

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

void main() {
  uint width = floatBitsToUint(push.eye.w);
  uint pixels = floatBitsToUint(push.corner.w);
  uint local = gl_GlobalInvocationID.x;
  uint pixel = push.first_pixel + local;
  bool live = local < pixels;
  vec2 film = vec2(float(pixel % width) + 0.5, float(pixel / width) + 0.5);
  if (kJittered != 0u && floatBitsToUint(push.down.w) != 0u) {
    uint place = shuffled(push.seed, push.count, push.words.z, pixel, push.sample_index, kPairImage);
    uvec2 bits = sample_bits(push.words, push.seed, push.count, pixel, place, kPairImage, kDomainSquare);
    film += kFilter != 0u ? filter_offset(bits) : unit_floats(bits) - 0.5;
  }
  Ray ray;
  ray.origin = push.eye.xyz;
  ray.direction = normalize(push.corner.xyz + film.x * push.across.xyz + film.y * push.down.xyz);
  ray.t_max = 3.0e38;
  ray.skip = kNoPrimitive;
  Hit hit = closest(ray, push.tree, live);

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
    error = 1.0e-6 * (abs(position) + abs(quadric_row(q, 3u).www));
  }
  if (kInstances != 0u) to_world(hit.instance, position, normal, error);
  bool front = dot(normal, ray.direction) < 0.0;
  normal = front ? normal : -normal;
  // Off the surface by the bound of the position's error, and outwards by the rounding of that sum.
  vec3 offset = dot(abs(normal), error) * normal;
  vec3 origin = position + offset;
  origin += sign(offset) * abs(origin) * 1.2e-7;
  // A degenerate triangle has no normal: treat the pixel as seeing nothing rather than spreading NaN.
  bool seen = live && hit.slot != kNoPrimitive && dot(normal, normal) > 0.5;
  if (live) {
    pixel -= floatBitsToUint(push.across.w);
    // A sphere seen from inside can be met again by a ray that leaves it.
    bool sphere = kHasQuadrics != 0u && (w0.w & kQuadricBit) != 0u && FETCH(quadric_texels, (w0.w & ~kQuadricBit) * 7u + 6u).x == kQuadricSphere;
    surfaces[pixel * 2u] = uvec4(floatBitsToUint(origin), seen && !sphere ? hit_id(hit) : kNoPrimitive);
    surfaces[pixel * 2u + 1u] = uvec4(floatBitsToUint(seen ? normal : ray.direction), seen ? 1u : 0u);
    if (kDetails != 0u) write_shading(pixel, hit, normal, front, seen);
  }
}
