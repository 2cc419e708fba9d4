#version 460
#extension GL_GOOGLE_include_directive : require
// The sample points alone, as bits: what tests compare with the host's samplers. Thread i: pixel i / count, index i % count. Dimension
// pair kPairComponent: the choice of a component, with a domain other than 0 for sets of their own.
#include "layout.h"

layout(local_size_x = kGroupSize) in;
layout(push_constant, std430) uniform Push { PointConstants push; };

#include "dispatch.glsl"
#include "fetch.glsl"
#include "sampling/sampler.glsl"

layout(set = 0, binding = kBindPoints, std430) writeonly buffer Points { uvec2 points[]; };

void main() {
  uint local = push.first + gl_GlobalInvocationID.x;
  uint count = max(push.split.x * push.split.y, 1u);  // 0: the warm-up run
  uint pixel = local / count;
  if (pixel < push.pixel_count) {
    uint index = local - pixel * count;
    uint part = index / push.split.y;
    uint place = shuffled_part(push.seed, push.split, pixel, part, index - part * push.split.y, push.dimension);
    place = push.dimension == 0u ? index : place;
    uint choice = component_choice(push.seed, pixel, part, index - part * push.split.y, push.split, push.domain != 0u);
    points[local] = push.dimension == kPairComponent ? uvec2(choice, 0u) : sample_bits(push.words, push.seed, count, pixel, place, push.dimension, push.domain);
  }
}
