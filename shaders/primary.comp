#version 460
#extension GL_GOOGLE_include_directive : require
// What each pixel sees. Reads the tree and, for jittered image samples, the sampler's table; writes two texels a pixel: the
// origin for rays that leave the surface with the primitive's id, and the normal that faces the viewer. One ray a thread.
#include "layout.h"

layout(local_size_x = kGroupSize) in;
layout(push_constant, std430) uniform Push { PrimaryConstants push; };
layout(constant_id = kSpecJittered) const uint kJittered = 0u;

#include "fetch.glsl"
#include "sampling/sampler.glsl"
#include "tracing/bvh.glsl"

layout(set = 0, binding = kBindSurfaces, std430) writeonly buffer Surfaces { uvec4 surfaces[]; };

// What shading needs, where it is asked for: shading normal and material; uv and area light.
layout(constant_id = kSpecDetails) const uint kDetails = 0u;
DATA_TEXELS(kBindDetails, detail_texels);
layout(set = 0, binding = kBindShading, std430) writeonly buffer Shading { uvec4 shading[]; };

// Octahedral, 16 bits a coordinate; 0: none.
vec3 unpack_normal(uint word) {
  vec2 o = (vec2(float(word & 0xffffu), float(word >> 16u)) - 1.0) * (2.0 / 65534.0) - 1.0;
  vec3 n = vec3(o, 1.0 - abs(o.x) - abs(o.y));
  float over = max(-n.z, 0.0);
  n.x += n.x >= 0.0 ? -over : over;
  n.y += n.y >= 0.0 ? -over : over;
  return word == 0u ? vec3(0.0) : normalize(n);
}

void write_shading(uint pixel, uint slot, vec3 weights, vec3 geometric) {
  uvec4 d0 = FETCH(detail_texels, slot * 3u);
  vec4 d1 = uintBitsToFloat(FETCH(detail_texels, slot * 3u + 1u));
  uvec4 d2 = FETCH(detail_texels, slot * 3u + 2u);
  vec3 n = weights.x * unpack_normal(d0.x) + weights.y * unpack_normal(d0.y) + weights.z * unpack_normal(d0.z);
  n = dot(n, n) > 0.0 ? normalize(n) : geometric;
  n = dot(n, geometric) < 0.0 ? -n : n;
  vec2 uv = weights.x * d1.xy + weights.y * d1.zw + weights.z * uintBitsToFloat(d2.xy);
  shading[pixel * 2u] = uvec4(floatBitsToUint(n), d0.w);
  shading[pixel * 2u + 1u] = uvec4(floatBitsToUint(uv), d2.z, 0u);
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
    film += unit_floats(bits) - 0.5;
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
  normal = dot(normal, ray.direction) > 0.0 ? -normal : normal;
  // Off the surface by the bound of the position's error, and outwards by the rounding of that sum.
  vec3 offset = dot(abs(normal), error) * normal;
  vec3 origin = position + offset;
  origin += sign(offset) * abs(origin) * 1.2e-7;
  // A degenerate triangle has no normal: treat the pixel as seeing nothing rather than spreading NaN.
  bool seen = live && hit.slot != kNoPrimitive && dot(normal, normal) > 0.5;
  if (live) {
    pixel -= floatBitsToUint(push.across.w);
    surfaces[pixel * 2u] = uvec4(floatBitsToUint(origin), seen ? hit_id(hit) : kNoPrimitive);
    surfaces[pixel * 2u + 1u] = uvec4(floatBitsToUint(normal), seen ? 1u : 0u);
    if (kDetails != 0u) write_shading(pixel, slot, hit.weights, normal);
  }
}
