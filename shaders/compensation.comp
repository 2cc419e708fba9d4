#version 460
#extension GL_GOOGLE_include_directive : require
// Rays for what a limit of the geometry term leaves out (docs/igi.md): short ones by the BSDF; the surfaces that they meet go on to be
// lit as those that pixels see. One ray a thread. Reads what pixels see, or such surfaces; writes six texels a ray: origin and
// primitive; normal and, above 0 where something counts, the index of its random numbers + 1; the way back and the pixel; shading
// normal and material; uv; what its light is multiplied by, and the number of what the ray came from.
#include "layout.h"

layout(local_size_x = kGroupSize) in;
layout(push_constant, std430) uniform Push { CompensationConstants push; };
#include "dispatch.glsl"
#include "fetch.glsl"
#include "sampling/sampler.glsl"
#include "sampling/warp.glsl"
#include "tracing/bvh.glsl"
#include "shading/trigonometry.glsl"
#include "shading/surface.glsl"
#include "shading/bsdf.glsl"
#include "tracing/hit_surface.glsl"

layout(set = 0, binding = kBindFound, std430) writeonly buffer Found { uvec4 found[]; };

void main() {
  uint lane = gl_GlobalInvocationID.x;
  uint local = lane / max(push.rays, 1u);
  bool inside = local < push.pixel_count;
  uint ray_number = lane - local * push.rays;
  uint pixel = push.first_pixel + (inside ? local : 0u);
  Surface s = load_surface(pixel - push.band, push.eye.xyz, inside);
  uint seed = floatBitsToUint(push.eye.w);
  uint index = push.part * push.rays + ray_number;
  vec2 u;
  float choice = 0.0;
  if (kReceivers == 0u) {
    u = unit_floats(sample_bits(push.words, seed, push.parts * push.rays, pixel, index, kPairIntegrand, kDomainDisk));
    uvec4 split = uvec4(push.parts, push.rays, push.part_stride, push.ray_stride);
    if (has(kMicrofacets)) choice = unit_floats(uvec2(component_choice(seed, pixel, push.part, ray_number, split, false))).x;
  } else {
    pixel = s.pixel;
    index = s.index;
    u = unit_floats(sample_random(seed, pixel, index, kPairOnwards + (push.level << 16u)));
    if (has(kMicrofacets)) choice = unit_floats(sample_random(seed, pixel, index, kPairComponent + (push.level << 16u))).y;
  }
  Bsdf bsdf = load_bsdf(s.material, s.uv, from_frame(s.wo, s.ns));
  vec3 i = sample_bsdf(bsdf, u, choice);
  vec3 w = normalize(to_frame(i, s.ns));
  bool lit = s.live && i.z > 0.0 && bsdf.o.z > 0.0 && dot(w, s.ng) > 0.0;
  i = lit ? i : vec3(0.0, 0.0, 1.0);
  vec4 f = evaluate_bsdf(bsdf, i);
  lit = lit && f.w > 0.0 && max(max(f.x, f.y), f.z) > 0.0;

  Ray ray;
  ray.origin = s.origin;
  ray.direction = w;
  ray.t_max = sqrt(i.z / push.limit);
  ray.skip = s.primitive;
  Hit hit = closest(ray, push.tree, lit);
  HitSurface h = surface_at(ray, hit, lit);
  float d2 = hit.t * hit.t * push.limit;
  float g = i.z * -dot(w, h.normal);  // over d2: the geometry term over its limit
  vec3 scale = f.xyz * (i.z / (lit ? f.w : 1.0)) * max(1.0 - d2 / (g > 0.0 ? g : 1.0), 0.0);
  bool counts_on = h.seen && g > d2 && max(max(scale.x, scale.y), scale.z) > 0.0;
  if (kReceivers != 0u) {
    float q = min(luminance(scale), 1.0);
    float end = unit_floats(sample_random(seed, pixel, index, kPairEnd + (push.level << 16u))).x;
    counts_on = counts_on && end < q;
    scale /= q > 0.0 ? q : 1.0;
  } else {
    scale /= float(max(push.rays, 1u));
  }
  if (inside) {
    found[lane * 6u] = uvec4(floatBitsToUint(h.origin), h.primitive);
    found[lane * 6u + 1u] = uvec4(floatBitsToUint(h.normal), counts_on ? index + 1u : 0u);
    found[lane * 6u + 2u] = uvec4(floatBitsToUint(-w), pixel);
    found[lane * 6u + 3u] = uvec4(floatBitsToUint(h.shading_normal), h.seen ? h.details.material : 0u);
    found[lane * 6u + 4u] = uvec4(floatBitsToUint(h.details.uv), 0u, 0u);
    found[lane * 6u + 5u] = uvec4(floatBitsToUint(scale), local);
  }
}
