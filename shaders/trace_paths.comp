#version 460
#extension GL_GOOGLE_include_directive : require
// One more bounce of every light path that is still under way (docs/igi.md): where it hits is a virtual light, and the BSDF says
// where it goes on. One path a thread. Reads the tree, materials and the sampler's table; writes five texels a path and its next ray.
#include "layout.h"

layout(local_size_x = kGroupSize) in;
#include "shading/paths.glsl"
#include "tracing/hit_surface.glsl"

layout(set = 0, binding = kBindPathHits, std430) writeonly buffer PathHits { uvec4 path_hits[]; };

const float kMostGoOn = 0.984375;  // 63/64

void main() {
  uint path = push.first + gl_GlobalInvocationID.x;
  bool inside = gl_GlobalInvocationID.x < push.batch;
  uint at = inside ? path : 0u;
  uvec4 s0 = paths[at * 3u], s1 = paths[at * 3u + 1u], s2 = paths[at * 3u + 2u];
  vec3 flux = uintBitsToFloat(s2.xyz);
  bool live = inside && max(max(flux.x, flux.y), flux.z) > 0.0;
  Ray ray;
  ray.origin = uintBitsToFloat(s0.xyz);
  ray.direction = live ? uintBitsToFloat(s1.xyz) : vec3(0.0, 0.0, 1.0);
  ray.t_max = 3e38;
  ray.skip = s0.w;
  ray.light = s1.w;
  ray.more_lights = s2.w;
  Hit hit = closest(ray, push.tree, live);
  HitSurface h = surface_at(ray, hit, live);
  vec3 a = -ray.direction;

  // Where it goes on. f is the path tracer's that comes from there; a shading normal on the other side of it gives way.
  uint set = at / max(push.split.y, 1u);
  uint index = at - set * push.split.y;
  vec2 u = unit_floats(path_bits(set, index, push.bounce, kPairBounce, kDomainDisk));
  float choice = has(kMicrofacets) ? path_choice(set, index, push.bounce) : 0.0;
  float end = unit_floats(path_bits(set, index, push.bounce, kPairGoingOn, kDomainSquare)).x;
  uint material = h.seen ? h.details.material : 0u;
  vec3 na = dot(h.shading_normal, a) > 0.0 ? h.shading_normal : h.normal;
  Bsdf from = load_bsdf(material, h.details.uv, from_frame(a, na));
  vec3 i = sample_bsdf(from, u, choice);
  vec3 w = normalize(to_frame(i, na));
  // Directions above the shading normal alone are of no use, those above the geometric one alone would never be found: they are
  // each other's opposites.
  w = dot(w, h.normal) < 0.0 ? -w : w;
  vec3 nw = dot(h.shading_normal, w) > 0.0 ? h.shading_normal : h.normal;
  vec3 a_local = from_frame(a, nw), w_local = from_frame(w, nw);
  bool reflects = h.seen && i.z > 0.0 && from.o.z > 0.0 && dot(w, h.normal) > 0.0 && dot(a, h.normal) > 0.0 && a_local.z > 0.0 && w_local.z > 0.0;
  i = reflects ? i : vec3(0.0, 0.0, 1.0);
  float pdf = evaluate_bsdf(from, i).w;
  Bsdf to = load_bsdf(material, h.details.uv, reflects ? w_local : vec3(0.0, 0.0, 1.0));
  vec3 f = evaluate_bsdf(to, reflects ? a_local : vec3(0.0, 0.0, 1.0)).xyz;
  reflects = reflects && pdf > 0.0;
  vec3 beta = f * (a_local.z * dot(w, h.normal) / (reflects ? dot(a, h.normal) * pdf : 1.0));
  float q = min(luminance(beta), kMostGoOn);
  bool goes_on = reflects && end < q;
  if (inside) {
    path_hits[at * 5u] = uvec4(floatBitsToUint(h.origin), h.primitive);
    path_hits[at * 5u + 1u] = uvec4(floatBitsToUint(h.normal), material);
    path_hits[at * 5u + 2u] = uvec4(floatBitsToUint(flux), h.seen ? 1u : 0u);
    path_hits[at * 5u + 3u] = uvec4(floatBitsToUint(h.shading_normal), floatBitsToUint(h.details.uv.x));
    path_hits[at * 5u + 4u] = uvec4(floatBitsToUint(a), floatBitsToUint(h.details.uv.y));
    paths[at * 3u] = uvec4(floatBitsToUint(h.origin), h.primitive);
    paths[at * 3u + 1u] = uvec4(floatBitsToUint(w), kNoPrimitive);
    paths[at * 3u + 2u] = uvec4(floatBitsToUint(goes_on ? flux * beta / q : vec3(0.0)), 0u);
  }
}
