#version 460
#extension GL_GOOGLE_include_directive : require
// What direct lighting's BSDFs and lights give for points alone, without rays: tests/render/device_samples_test.cpp compares it.
#include "layout.h"

layout(local_size_x = kGroupSize) in;
layout(constant_id = kSpecLight) const uint kLight = kLightDisk;
layout(push_constant, std430) uniform Push { uint mode, count; } push;
#include "fetch.glsl"
#include "sampling/warp.glsl"
#include "shading/trigonometry.glsl"
#include "tracing/ray.glsl"
#include "tracing/quadric.glsl"
vec2 unit_floats(uvec2 bits) { return vec2(bits >> 8u) * 5.9604644775390625e-8; }
#include "shading/bsdf.glsl"
#include "shading/environment.glsl"
#include "shading/lights.glsl"

DATA_TEXELS(kBindRays, questions);  // three texels each: a vector and an index; a second vector; bits of a point and of a choice
layout(set = 0, binding = kBindSums, std430) writeonly buffer Answers { vec4 answers[]; };  // two each

void main() {
  uint thread = gl_GlobalInvocationID.x;
  uint at = min(thread, push.count - 1u) * 3u;
  uvec4 t0 = FETCH(questions, at), t2 = FETCH(questions, at + 2u);
  vec3 first = uintBitsToFloat(t0.xyz), second = uintBitsToFloat(FETCH(questions, at + 1u).xyz);
  vec4 a, b;
  if (push.mode == 0u) {  // a BSDF seen from `first`: direction and its density, and f
    Bsdf bsdf = load_bsdf(t0.w, vec2(0.0), first);
    vec3 i = sample_bsdf(bsdf, unit_floats(t2.xy), unit_floats(t2.zz).x);
    bool above = i.z > 0.0;
    vec4 f = evaluate_bsdf(bsdf, above ? i : vec3(0.0, 0.0, 1.0));
    a = vec4(i, above ? f.w : 0.0);
    b = vec4(f.xyz, 0.0);
  } else if (push.mode == 1u) {  // a light, from `first`, where the normal is `second`: direction and density, radiance and distance
    LightSample s = sample_light(kLight, load_light(t0.w), first, second, t2.xy);
    a = vec4(s.w, s.pdf);
    b = vec4(s.radiance, s.t);
  } else {  // what a ray from `first` towards `second` meets of a light: density and distance, radiance
    Light l = load_light(t0.w);
    Ray ray;
    ray.origin = first;
    ray.direction = second;
    ray.t_max = 3e38;
    ray.skip = kNoPrimitive;
    vec3 radiance;
    float pdf, t = 3e38;
    if (l.kind <= kLightTriangles) {
      t = meet_light(l, ray, radiance, pdf);
    } else {
      radiance = environment_towards(l, second, vec3(0.0, 0.0, 1.0), pdf);
    }
    a = vec4(0.0, 0.0, t, pdf);
    b = vec4(radiance, 0.0);
  }
  if (thread < push.count) {
    answers[thread * 2u] = a;
    answers[thread * 2u + 1u] = b;
  }
}
