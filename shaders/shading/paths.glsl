// What the kernels of light paths share: a path's ray, and the place of its points (docs/igi.md).
layout(push_constant, std430) uniform Push { PathConstants push; };
#define RAYS_TO_LIGHTS
#include "dispatch.glsl"
#include "fetch.glsl"
#include "sampling/sampler.glsl"
#include "sampling/warp.glsl"
#include "tracing/bvh.glsl"
#include "shading/trigonometry.glsl"
#include "shading/bsdf.glsl"
#include "shading/environment.glsl"
#include "shading/lights.glsl"

// Origin with the primitive that it leaves; direction with the first of the light's primitives that it leaves; the flux, with how
// many more of those there are.
layout(set = 0, binding = kBindPaths, std430) buffer Paths { uvec4 paths[]; };

bool separate_sets() { return (push.flags & kDirectSeparate) != 0u; }

// The point of path `index` of `set` of a dimension pair of a bounce.
uvec2 path_bits(uint set, uint index, uint bounce, uint pair, uint domain) {
  index = path_point(push.seed, set, index, push.split.y, bounce, pair);
  bool separate = separate_sets();
  uint dimension = separate ? pair + (set << 16u) : pair;
  uint sets = separate ? 1u : push.split.x;
  uint part = separate ? 0u : set;
  uint moved = shuffled_part(push.seed, uvec4(sets, push.split.yzw), bounce, part, index, dimension);
  uint place = dimension == 0u ? part * push.split.y + index : moved;
  return sample_bits(push.words, push.seed, sets * push.split.y, bounce, place, dimension, domain);
}

// The number that chooses a component.
float path_choice(uint set, uint index, uint bounce) {
  return unit_floats(uvec2(component_choice(push.seed, bounce, set, index, push.split, separate_sets()))).x;
}
