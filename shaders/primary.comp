#version 460
#extension GL_GOOGLE_include_directive : require
// What each pixel sees. Reads the tree and, for jittered image samples, the sampler's table; writes two texels a pixel: the
// origin for rays that leave the surface with the primitive's id, and the normal that faces the viewer (where nothing is seen: the
// ray's direction). One ray a thread.
#include "layout.h"

layout(local_size_x = kGroupSize) in;
layout(push_constant, std430) uniform Push { PrimaryConstants push; };
layout(constant_id = kSpecJittered) const uint kJittered = 0u;

#include "dispatch.glsl"
#include "fetch.glsl"
#include "sampling/sampler.glsl"
#include "sampling/filter.glsl"
#include "tracing/bvh.glsl"

layout(set = 0, binding = kBindSurfaces, std430) writeonly buffer Surfaces { uvec4 surfaces[]; };

// What shading needs, where it is asked for: shading normal and material; uv, light and whether it shines this way.
layout(set = 0, binding = kBindShading, std430) writeonly buffer Shading { uvec4 shading[]; };
#include "tracing/hit_surface.glsl"

void write_shading(uint place, HitSurface s) {
  Details d = s.details;
  bool shines = s.front != ((d.light & kLightTurned) != 0u);
  shading[place * 2u] = uvec4(floatBitsToUint(s.shading_normal), d.material);
  shading[place * 2u + 1u] = uvec4(floatBitsToUint(d.uv), s.seen ? d.light & ~kLightTurned : kNoLight, shines ? 1u : 0u);
}

void main() {
  uint width = floatBitsToUint(push.eye.w);
  uint pixels = floatBitsToUint(push.corner.w);
  uint local = gl_GlobalInvocationID.x;
  bool live = local < pixels;
  uint pixel = push.first_pixel + (live ? block_place(local, pixels, width) : 0u);
  vec2 film = vec2(float(pixel % width) + 0.5, float(pixel / width) + 0.5);
  if (kJittered != 0u && floatBitsToUint(push.down.w) != 0u) {
    uint place = shuffled(push.seed, push.count, push.words.z, pixel, push.sample_index, kPairImage);
    uvec2 bits = sample_bits(push.words, push.seed, push.count, pixel, place, kPairImage, kDomainSquare);
    film += kFilter != 0u ? filter_offset(bits) : unit_floats(bits) - 0.5;
  }
  Ray ray;
  vec3 from_corner = film.x * push.across.xyz + film.y * push.down.xyz;
  ray.origin = push.eye.xyz + push.tree.grid_scale.w * from_corner;
  ray.direction = normalize(push.corner.xyz + from_corner);
  ray.t_max = 3.0e38;
  ray.skip = kNoPrimitive;
  Hit hit = closest(ray, push.tree, live);

  HitSurface s = surface_at(ray, hit, live);
  if (live) {
    pixel -= floatBitsToUint(push.across.w);
    surfaces[pixel * 2u] = uvec4(floatBitsToUint(s.origin), s.primitive);
    surfaces[pixel * 2u + 1u] = uvec4(floatBitsToUint(s.seen ? s.normal : ray.direction), s.seen ? 1u : 0u);
    if (kDetails != 0u) write_shading(pixel, s);
  }
}
