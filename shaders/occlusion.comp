#version 460
#extension GL_GOOGLE_include_directive : require
// Ambient occlusion: one ray a thread, cosine-weighted, from what a pixel sees; counts those that meet nothing within the
// radius. Reads surfaces, the tree and the sampler's table; adds to one counter a pixel (integers: any order, same bits).
#include "layout.h"

layout(local_size_x = kGroupSize) in;
layout(push_constant, std430) uniform Push { OcclusionConstants push; };

#include "dispatch.glsl"
#include "fetch.glsl"
#include "sampling/sampler.glsl"
#include "sampling/warp.glsl"
#include "tracing/bvh.glsl"

DATA_TEXELS(kBindSurfaces, surface_texels);
DATA_TEXELS(kBindOrder, order_texels);
layout(constant_id = kSpecOrdered) const uint kOrdered = 0u;
layout(set = 0, binding = kBindCounts, std430) buffer Counts { uint counts[]; };

void main() {
  uint local = spread_group(push.group_stride) * kGroupSize + gl_LocalInvocationIndex;
  uint pixel_in_batch = divide_small(local, max(push.samples, 1u));  // 0 samples: the warm-up run
  uint index = push.first_sample + local - pixel_in_batch * push.samples;
  if (kOrdered != 0u) index = FETCH(order_texels, index).x;  // neighbouring lanes get neighbouring directions
  bool inside = pixel_in_batch < push.pixel_count;
  uint pixel = push.first_pixel + (inside ? pixel_in_batch : 0u);
  uint place = pixel - push.band;
  uvec4 at = FETCH(surface_texels, place * 2u);
  uvec4 facing = FETCH(surface_texels, place * 2u + 1u);
  bool live = inside && facing.w != 0u;

  vec2 u = unit_floats(sample_bits(push.words, push.seed, push.count, pixel, index, 0u, kDomainDisk));
  Ray ray;
  ray.origin = uintBitsToFloat(at.xyz);
  ray.direction = normalize(to_frame(cosine_hemisphere(u), uintBitsToFloat(facing.xyz)));
  ray.t_max = push.radius;
  ray.skip = at.w;
  uint visible = !occluded(ray, push.tree, live) && live ? 1u : 0u;
  visible = gathered(visible, place);
  if (visible != 0u) atomicAdd(counts[place], visible);
}
