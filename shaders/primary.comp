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

void main() {
  uint width = floatBitsToUint(push.eye.w);
  uint pixels = floatBitsToUint(push.corner.w);
  uint local = gl_GlobalInvocationID.x;
  uint pixel = push.first_pixel + local;
  bool live = local < pixels;
  vec2 film = vec2(float(pixel % width) + 0.5, float(pixel / width) + 0.5);
  if (kJittered != 0u) {
    film += unit_floats(sample_bits(push.words, push.seed, push.count, pixel, push.sample_index, 1u)) - 0.5;
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
  normal = dot(normal, ray.direction) > 0.0 ? -normal : normal;
  // Off the surface by the bound of the position's error, and outwards by the rounding of that sum.
  vec3 offset = dot(abs(normal), error) * normal;
  vec3 origin = position + offset;
  origin += sign(offset) * abs(origin) * 1.2e-7;
  // A degenerate triangle has no normal: treat the pixel as seeing nothing rather than spreading NaN.
  bool seen = live && hit.slot != kNoPrimitive && dot(normal, normal) > 0.5;
  if (live) {
    surfaces[pixel * 2u] = uvec4(floatBitsToUint(origin), seen ? w0.w : kNoPrimitive);
    surfaces[pixel * 2u + 1u] = uvec4(floatBitsToUint(normal), seen ? 1u : 0u);
  }
}
