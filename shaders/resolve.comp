#version 460
#extension GL_GOOGLE_include_directive : require
// Adds the samples of a batch to their pixels, one pixel a thread, in the order of the samples: same bits every time. The sum is
// kept with what rounding took from it (Kahan), so that millions of samples still count.
#include "layout.h"

layout(local_size_x = kGroupSize) in;
layout(push_constant, std430) uniform Push { ResolveConstants push; };
#include "fetch.glsl"

DATA_TEXELS(kBindSamples, sample_texels);
layout(set = 0, binding = kBindSums, std430) buffer Sums { vec4 sums[]; };

void main() {
  uint local = gl_GlobalInvocationID.x;
  bool live = local < push.pixel_count;
  uint place = push.first_pixel - push.band + (live ? local : 0u);
  precise vec4 sum = live ? sums[place * 2u] : vec4(0.0);
  precise vec4 lost = live ? sums[place * 2u + 1u] : vec4(0.0);
  uint first = (live ? local : 0u) * push.samples;
  for (uint k = 0u; k < push.samples; ++k) {
    precise vec4 term = uintBitsToFloat(FETCH(sample_texels, first + k)) * push.weight - lost;
    precise vec4 next = sum + term;
    lost = (next - sum) - term;
    sum = next;
  }
  if (live) {
    sums[place * 2u] = sum;
    sums[place * 2u + 1u] = lost;
  }
}
