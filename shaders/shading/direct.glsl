// What the kernels of direct lighting share: the batch's numbering, and the place of a sample's points.
layout(push_constant, std430) uniform Push { DirectConstants push; };
#define RAYS_TO_LIGHTS
#include "dispatch.glsl"
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
#include "shading/visible_part.glsl"

layout(set = 0, binding = kBindSamples, std430) buffer Samples { vec4 samples[]; };

DATA_TEXELS(kBindOrder, order_texels);
layout(constant_id = kSpecOrdered) const uint kOrdered = 0u;

struct Job {
  uint slot;   // where its result goes
  uint pixel;
  uint part, index;
  bool live;
};

Job this_job() {
  Job job;
  job.slot = spread_group(push.group_stride) * kGroupSize + gl_LocalInvocationIndex;
  uint local = divide_small(job.slot, max(push.samples, 1u));  // 0 samples: the warm-up run
  uint index = push.first_sample + job.slot - local * push.samples;
  if (kOrdered != 0u) index = FETCH(order_texels, index).x;  // neighbouring lanes get neighbouring directions
  job.live = local < push.pixel_count;
  job.pixel = push.first_pixel + (job.live ? local : 0u);
  job.part = 0u;
  if (push.split.x > 1u) job.part = index / push.split.y;
  job.index = index - job.part * push.split.y;
  return job;
}

uint seed_of() { return floatBitsToUint(push.eye.w); }
bool separate_sets() { return (push.flags & kDirectSeparate) != 0u; }

// What a surface that a ray met is addressed by.
Job addressed(Job job, Surface s) {
  if (kReceivers != 0u) {
    job.pixel = s.pixel;
    job.index = s.index;
    job.part = 0u;
  }
  return job;
}

// Such surfaces have independent points.
uvec2 independent_point(Job job, uint dimension) { return sample_random(seed_of(), job.pixel, job.index, dimension + (push.level << 16u)); }

uvec2 point_at(Job job, uint place, uint dimension, uint domain) {
  bool separate = separate_sets();
  uint count = separate ? push.split.y : push.split.x * push.split.y;
  return sample_bits(push.words, seed_of(), count, job.pixel, place, separate ? dimension + (job.part << 16u) : dimension, domain);
}

// A point of a light. They are only added up: their order within a part is free, and that of the parts too, unless each part
// has a place in the pixel of its own.
uvec2 light_point(Job job, uint dimension, uint domain) {
  if (kReceivers != 0u) return independent_point(job, dimension);
  uint place = job.index;
  bool waits = !separate_sets();
  uint part = job.part;
  if (waits && (push.flags & kDirectPlaces) != 0u) {
    uint key = set_words(seed_of(), job.pixel, dimension, kPurposeSet).z;
    part = shuffled_part_only(key, push.split, job.part, dimension);
  }
  place += waits ? part * push.split.y : 0u;
  // Which points the first of a longer set are is a matter of their order.
  if (kSampler == kSamplerCapconRanked) {
    uint alone = place_in_order(push.split.y, push.split.w, job.index, dimension, 0u);
    uint among = shuffled_part(seed_of(), push.split, job.pixel, job.part, job.index, dimension);
    place = waits ? among : alone;
  }
  return point_at(job, place, dimension, domain);
}

// The BSDF's point, in the order of the component's choice.
uvec2 bsdf_point(Job job) {
  if (kReceivers != 0u) return independent_point(job, kPairIntegrand);
  bool separate = separate_sets();
  uint place = separate ? job.index : job.part * push.split.y + job.index;
  bool waits = separate && job.part > 0u && (has(kMicrofacets) || kSampler == kSamplerCapconRanked);
  if (waits) place = shuffled(seed_of(), push.split.y, push.split.w, job.pixel, job.index, kPairIntegrand + (job.part << 16u));
  return point_at(job, place, kPairIntegrand, kDomainDisk);
}

float choice_of(Job job) {
  if (kReceivers != 0u) return unit_floats(independent_point(job, kPairComponent)).x;
  uint bits = component_choice(seed_of(), job.pixel, job.part, job.index, push.split, separate_sets());
  return unit_floats(uvec2(bits)).x;
}

void write_sample(Job job, vec3 radiance) {
  vec4 before = vec4(0.0);
  if ((push.flags & kDirectFirst) == 0u) before = samples[job.slot];
  if (job.live) samples[job.slot] = vec4(radiance, 0.0) + before;
}
