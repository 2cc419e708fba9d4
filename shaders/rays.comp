#version 460
#extension GL_GOOGLE_include_directive : require
// Given rays against the scene, closest or any hit: what tests and the tracer's bench compare with other tracers, ray for ray.
// Reads two texels a ray (origin, t_max; direction, primitive to skip), writes its distance and the primitive's id.
#include "layout.h"

layout(local_size_x = kGroupSize, local_size_x_id = kSpecGroupSize) in;
layout(push_constant, std430) uniform Push { RayConstants push; };
layout(constant_id = kSpecAnyHit) const uint kAnyHit = 0u;

#include "dispatch.glsl"
#include "fetch.glsl"
#include "tracing/bvh.glsl"
#ifdef FETCH_TEXEL
#include "tracing/ray_queue.glsl"
#endif

DATA_TEXELS(kBindRays, ray_texels);
layout(set = 0, binding = kBindHits, std430) writeonly buffer Hits { uvec2 hits[]; };

Ray queued_ray(uint index) {
  uvec4 r0 = FETCH(ray_texels, index * 2u);
  uvec4 r1 = FETCH(ray_texels, index * 2u + 1u);
  Ray ray;
  ray.origin = uintBitsToFloat(r0.xyz);
  ray.direction = uintBitsToFloat(r1.xyz);
  ray.t_max = uintBitsToFloat(r0.w);
  ray.skip = r1.w;
  return ray;
}

#ifdef FETCH_TEXEL
void queued_answer(uint index, Ray ray, bool hit, bool answered) {
  if (answered) hits[index] = uvec2(0u, hit ? 0u : kNoPrimitive);
}
#endif

void main() {
#ifdef FETCH_TEXEL
  if (kQueue != 0u && kAnyHit != 0u) {
    occluded_queue(push.count, push.group_rays, push.group_stride, push.enough, push.resumed != 0u, push.first, push.tree);
    return;
  }
#endif
  uint index = spread_group(push.group_stride) * gl_WorkGroupSize.x + gl_LocalInvocationIndex;
  bool live = index < push.count;
  index = push.first + (live ? index : 0u);
  Ray ray = queued_ray(index);
  Hit hit;
  if (kAnyHit != 0u) {
    hit = Hit(0.0, 0u, 0u, vec3(0.0));
    hit.slot = occluded(ray, push.tree, live) ? 0u : kNoPrimitive;
  } else {
    hit = closest(ray, push.tree, live);
  }
  uint id = kAnyHit != 0u ? hit.slot : hit_id(hit);
  if (live) hits[index] = uvec2(floatBitsToUint(hit.t), id);
}
