// What the kernels of direct lighting share: the batch's numbering, and the place of a sample's points.
layout(push_constant, std430) uniform Push { DirectConstants push; };
#define RAYS_TO_LIGHTS
#include "fetch.glsl"
#include "sampling/sampler.glsl"
#include "sampling/warp.glsl"
#include "tracing/bvh.glsl"
#include "shading/trigonometry.glsl"
#include "shading/surface.glsl"
#include "shading/bsdf.glsl"
#include "shading/environment.glsl"
#include "shading/lights.glsl"
#include "shading/mis.glsl"

layout(set = 0, binding = kBindSamples, std430) buffer Samples { vec4 samples[]; };

// Rays that end on a light stop short of it, so that what it is flush with does not hide it.
const float kShort = 0.99999237060546875;  // 1 - 2^-17

struct Job {
  uint slot;   // where its result goes
  uint pixel;
  uint part, index;
  bool live;
};

Job this_job() {
  // The driver may hand each of its threads one contiguous piece: a stride coprime to the number of groups spreads the work.
  uint group = (gl_WorkGroupID.x * push.group_stride) % gl_NumWorkGroups.x;
  Job job;
  job.slot = group * kGroupSize + gl_LocalInvocationIndex;
  uint local = job.slot / max(push.samples, 1u);  // 0 samples: the warm-up run
  uint index = push.first_sample + job.slot - local * push.samples;
  job.live = local < push.pixel_count;
  job.pixel = push.first_pixel + (job.live ? local : 0u);
  job.part = index / max(push.split.y, 1u);
  job.index = index - job.part * push.split.y;
  return job;
}

// The point of a dimension pair.
uvec2 point_of(Job job, uint dimension, uint domain) {
  uint seed = floatBitsToUint(push.eye.w);
  bool separate = (push.flags & kDirectSeparate) != 0u;
  uint number = separate ? dimension + (job.part << 16u) : dimension;
  uint count = separate ? push.split.y : push.split.x * push.split.y;
  uint part = separate ? 0u : job.part;
  uvec4 split = uvec4(separate ? 1u : push.split.x, push.split.y, separate ? 1u : push.split.z, push.split.w);
  uint place = number == 0u ? part * push.split.y + job.index : shuffled_part(seed, split, job.pixel, part, job.index, number);
  return sample_bits(push.words, seed, count, job.pixel, place, number, domain);
}

void write_sample(Job job, vec3 radiance) {
  bool first = (push.flags & kDirectFirst) != 0u;
  if (job.live) samples[job.slot] = vec4(radiance, 0.0) + (first ? vec4(0.0) : samples[job.slot]);
}
