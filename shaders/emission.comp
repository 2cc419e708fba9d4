#version 460
#extension GL_GOOGLE_include_directive : require
// Adds what a pixel sees of the lights themselves: the emitting side of an area light, or the environments where nothing is met.
#include "layout.h"

layout(local_size_x = kGroupSize) in;
layout(push_constant, std430) uniform Push { EmissionConstants push; };
#include "fetch.glsl"
#include "sampling/warp.glsl"
#include "shading/trigonometry.glsl"
#include "tracing/ray.glsl"
#include "tracing/quadric.glsl"
vec2 unit_floats(uvec2 bits) { return vec2(bits >> 8u) * 5.9604644775390625e-8; }
#include "shading/environment.glsl"
#include "shading/lights.glsl"

DATA_TEXELS(kBindSurfaces, surface_texels);
DATA_TEXELS(kBindShading, shading_texels);
layout(set = 0, binding = kBindSums, std430) buffer Sums { vec4 sums[]; };

void main() {
  uint local = gl_GlobalInvocationID.x;
  bool live = local < push.pixel_count;
  uint place = push.first_pixel - push.band + (live ? local : 0u);
  uvec4 facing = FETCH(surface_texels, place * 2u + 1u);
  uvec4 s1 = FETCH(shading_texels, place * 2u + 1u);
  bool seen = facing.w != 0u;
  vec3 radiance = vec3(0.0);
  bool shows = seen && s1.z != kNoLight;
  if (push.light > 0u) {
    Light l = load_light(shows ? s1.z : 0u);
    radiance = shows && shines(l, s1.w != 0u) ? l.radiance : vec3(0.0);
  }
  for (uint k = push.light; k < push.lights; ++k) {
    Light l = load_light(k);
    float pdf;
    vec3 sky = environment_towards(l, uintBitsToFloat(facing.xyz), vec3(0.0, 0.0, 1.0), pdf);
    radiance += !seen && (l.kind == kLightMap || l.kind == kLightConstant) ? sky : vec3(0.0);
  }
  if (live) {
    precise vec4 sum = sums[place * 2u];
    precise vec4 term = vec4(radiance * push.weight, 0.0) - sums[place * 2u + 1u];
    precise vec4 next = sum + term;
    sums[place * 2u + 1u] = (next - sum) - term;
    sums[place * 2u] = next;
  }
}
