#version 460
#extension GL_GOOGLE_include_directive : require
// Ambient occlusion: one ray a thread, cosine-weighted, from what a pixel sees; counts those that meet nothing within the
// radius. Reads surfaces, the tree and the sampler's table; adds to one counter a pixel (integers: any order, same bits).
#include "layout.h"

layout(local_size_x = kGroupSize, local_size_x_id = kSpecGroupSize) in;
layout(push_constant, std430) uniform Push { OcclusionConstants push; };

#include "dispatch.glsl"
#include "fetch.glsl"
#include "sampling/sampler.glsl"
#include "sampling/warp.glsl"
#include "tracing/bvh.glsl"
#ifdef FETCH_TEXEL
#include "tracing/ray_queue.glsl"
#endif

DATA_TEXELS(kBindSurfaces, surface_texels);
DATA_TEXELS(kBindOrder, order_texels);
layout(constant_id = kSpecOrdered) const uint kOrdered = 0u;
layout(set = 0, binding = kBindCounts, std430) buffer Counts { uint counts[]; };

uint place_of(uint number) { return push.first_pixel - push.band + divide_small(number, max(push.samples, 1u)); }  // 0: the warm-up

// The ray of a number below pixels times samples of the batch; `live`: the pixel sees something.
Ray occlusion_ray(uint number, out bool live) {
  uint place = place_of(number);
  uint pixel = place + push.band;
  uint index = push.first_sample + number - (pixel - push.first_pixel) * push.samples;
  if (kOrdered != 0u) index = FETCH(order_texels, index).x;  // neighbouring lanes get neighbouring directions
  uvec4 at = FETCH(surface_texels, place * 2u);
  uvec4 facing = FETCH(surface_texels, place * 2u + 1u);
  live = facing.w != 0u;
  vec2 u = unit_floats(sample_bits(push.words, push.seed, push.count, pixel, index, 0u, kDomainDisk));
  Ray ray;
  ray.origin = uintBitsToFloat(at.xyz);
  ray.direction = normalize(to_frame(cosine_hemisphere(u), uintBitsToFloat(facing.xyz)));
  ray.t_max = push.radius;
  ray.skip = at.w;
  return ray;
}

void count_visible(uint place, bool visible) {
  uint sum = gathered(visible ? 1u : 0u, place);
  if (sum != 0u) atomicAdd(counts[place], sum);
}

#ifdef FETCH_TEXEL
Ray queued_ray(uint number) {
  bool live;
  Ray ray = occlusion_ray(number, live);
  ray.t_max = live ? ray.t_max : -1.0;
  return ray;
}
void queued_answer(uint number, Ray ray, bool hit, bool answered) {
  count_visible(place_of(answered ? number : 0u), answered && !hit && ray.t_max >= 0.0);
}
#endif

void main() {
  uint rays = push.pixel_count * push.samples;
#ifdef FETCH_TEXEL
  if (kQueue != 0u) {
    occluded_queue(rays, push.group_rays, push.group_stride, push.enough, push.resumed != 0u, 0u, push.tree);
    return;
  }
#endif
  uint number = spread_group(push.group_stride) * gl_WorkGroupSize.x + gl_LocalInvocationIndex;
  bool inside = number < rays;
  number = inside ? number : 0u;
  bool live;
  Ray ray = occlusion_ray(number, live);
  live = live && inside;
  count_visible(place_of(number), !occluded(ray, push.tree, live) && live);
}
