#version 460
#extension GL_GOOGLE_include_directive : require
// Light from virtual lights (docs/igi.md): one of them and one pixel a thread, neighbouring threads having neighbouring pixels and the
// same virtual light, so that their rays are coherent. Reads what pixels see, materials, virtual lights and the tree; writes one texel
// a pixel and virtual light.
#include "layout.h"

layout(local_size_x = kGroupSize) in;
layout(push_constant, std430) uniform Push { GatherConstants push; };
#define RAYS_TO_LIGHTS
#include "dispatch.glsl"
#include "fetch.glsl"
vec2 unit_floats(uvec2 bits) { return vec2(bits >> 8u) * 5.9604644775390625e-8; }
#include "sampling/warp.glsl"
#include "tracing/bvh.glsl"
#include "shading/trigonometry.glsl"
#include "shading/surface.glsl"
#include "shading/bsdf.glsl"
#include "shading/visible_part.glsl"

DATA_TEXELS(kBindVirtualLights, virtual_light_texels);
layout(set = 0, binding = kBindSamples, std430) writeonly buffer Samples { vec4 samples[]; };

void main() {
  uint lane = spread_group(push.group_stride) * kGroupSize + gl_LocalInvocationIndex;
  uint k = divide(lane, max(push.lanes, 1u));
  uint p = lane - k * push.lanes;
  uint row = divide(p, max(push.across, 1u));
  uint x = push.residue_x + (p - row * push.across) * push.block;
  uint pixel = push.block > 1u ? (push.row + row * push.block) * push.width + x : push.first_pixel + p;
  bool inside = p < push.lanes && k < push.columns && pixel >= push.first_pixel && pixel - push.first_pixel < push.pixel_count;
  uint local = inside ? pixel - push.first_pixel : 0u;
  bool there = inside && k < push.count;
  Surface s = load_surface(push.first_pixel + local - push.band, push.eye.xyz, there);

  uint at = (push.first + (there ? k : 0u)) * 5u;
  uvec4 t0 = FETCH(virtual_light_texels, at), t1 = FETCH(virtual_light_texels, at + 1u);
  uvec4 t3 = FETCH(virtual_light_texels, at + 3u), t4 = FETCH(virtual_light_texels, at + 4u);
  vec3 flux = uintBitsToFloat(FETCH(virtual_light_texels, at + 2u).xyz);
  vec3 normal = uintBitsToFloat(t1.xyz), shading_normal = uintBitsToFloat(t3.xyz), a = uintBitsToFloat(t4.xyz);

  vec3 d = uintBitsToFloat(t0.xyz) - s.origin;
  float d2 = max(dot(d, d), 1e-30);
  float reach = sqrt(d2);
  vec3 w = d / reach;
  // Seen from behind, a two-sided one is as if its path had come from there.
  bool behind = push.two_sided != 0u && dot(w, normal) > 0.0;
  a = behind ? a - 2.0 * dot(a, normal) * normal : a;
  normal = behind ? -normal : normal;
  shading_normal = behind ? -shading_normal : shading_normal;
  float below = -dot(w, normal);
  vec3 there_normal = dot(shading_normal, w) < 0.0 ? shading_normal : normal;
  vec3 i = from_frame(w, s.ns), o = from_frame(s.wo, s.ns);
  vec3 from = from_frame(a, there_normal), to = from_frame(-w, there_normal);
  float facing = dot(a, normal);
  bool lit = s.live && i.z > 0.0 && o.z > 0.0 && dot(w, s.ng) > 0.0 && below > 0.0 && from.z > 0.0 && to.z > 0.0 && facing > 0.0;
  const vec3 up = vec3(0.0, 0.0, 1.0);
  Bsdf here = load_bsdf(s.material, s.uv, lit ? o : up);
  Bsdf beyond = load_bsdf(t1.w, uintBitsToFloat(uvec2(t3.w, t4.w)), lit ? to : up);
  vec3 f = evaluate_bsdf(here, lit ? i : up).xyz * evaluate_bsdf(beyond, lit ? from : up).xyz;
  float g = min(push.eye.w, i.z * below / d2);
  vec3 radiance = f * (g * from.z / (lit ? facing : 1.0)) * flux;
  lit = lit && max(max(radiance.x, radiance.y), radiance.z) > 0.0;

  Ray ray;
  ray.origin = s.origin;
  ray.direction = w;
  ray.t_max = reach * kShort;
  ray.skip = s.primitive;
  ray.light = t0.w;
  ray.more_lights = 0u;
  bool visible = !occluded(ray, push.tree, lit) && lit;
  if (inside) samples[local * push.columns + k] = vec4(visible ? radiance : vec3(0.0), 0.0);
}
