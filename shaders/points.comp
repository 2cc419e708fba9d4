#version 460
#extension GL_GOOGLE_include_directive : require
// The sample points alone, as bits: what tests compare with the host's samplers. Thread i: pixel i / count, index i % count.
#include "layout.h"

layout(local_size_x = kGroupSize) in;
layout(push_constant, std430) uniform Push { OcclusionConstants push; };

#include "fetch.glsl"
#include "sampling/sampler.glsl"

layout(set = 0, binding = kBindPoints, std430) writeonly buffer Points { uvec2 points[]; };

void main() {
  uint local = gl_GlobalInvocationID.x;
  uint pixel = local / max(push.count, 1u);  // 0: the warm-up run
  if (pixel < push.pixel_count) {
    points[local] =
        sample_bits(push.words, push.seed, push.count, push.first_pixel + pixel, local - pixel * push.count, push.samples);
  }
}
