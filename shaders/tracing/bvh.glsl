// The tree: nodes of four children in 64 bytes, four texels each (host/scene/bvh.h): the x, y and z planes of the children
// as pairs of 16-bit grid coordinates, then children, first primitive and primitive masks.
//
// Written for lanes that run in step (docs/tracer.md): no branches but loops; loops test at the bottom; every value that is
// read after a loop is carried through it, never simply set in it (CONTRIBUTING, "Shaders on lavapipe").
DATA_TEXELS(kBindNodes, node_texels);
DATA_TEXELS(kBindPrimitives, primitive_texels);

#include "tracing/ray.glsl"
#include "tracing/triangle.glsl"
#include "tracing/quadric.glsl"

#include "tracing/stack.glsl"

struct Hit {
  float t;
  uint slot;  // of the primitive in leaf order; kNoPrimitive: nothing was met
  vec3 weights;
};

// A group of sibling nodes still to be visited, in one word: first sibling << 8 | three 2-bit slots, nearest lowest | count.
const uint kNoGroup = 0u;
const uint kNoNode = 0xffffffffu;
const float kFarther = 1.0000012;  // the far planes' share of the rounding of (plane - origin) * inverse

// Visits the tree until a primitive is met (any) or the nearest is known. ANY hits are not the nearest.
Hit traverse(const bool any, Ray ray, TreeConstants tree, bool live) {
  GridRay g = to_grid(ray, tree);
  RayFrame frame = ray_frame(ray.direction);
  Hit hit = Hit(ray.t_max, kNoPrimitive, vec3(0.0));
  STACK_REGISTERS
  uint node = live ? 0u : kNoNode;
  uint first = 0u;
  uint mask = 0u;  // primitives first + bit that are still to be tested
  do {
    do {
      // A lane that has nothing to visit runs along on the root and changes nothing.
      bool visiting = node != kNoNode && mask == 0u;
      uint at = visiting ? node * 4u : 0u;
      uvec4 x = FETCH(node_texels, at);
      uvec4 y = FETCH(node_texels, at + 1u);
      uvec4 z = FETCH(node_texels, at + 2u);
      uvec4 links = FETCH(node_texels, at + 3u);
      vec4 near_x = (vec4((x >> g.shift.x) & 0xffffu) - g.near.x) * g.inverse.x;
      vec4 far_x = (vec4((x >> (16u - g.shift.x)) & 0xffffu) - g.far.x) * g.inverse.x;
      vec4 near_y = (vec4((y >> g.shift.y) & 0xffffu) - g.near.y) * g.inverse.y;
      vec4 far_y = (vec4((y >> (16u - g.shift.y)) & 0xffffu) - g.far.y) * g.inverse.y;
      vec4 near_z = (vec4((z >> g.shift.z) & 0xffffu) - g.near.z) * g.inverse.z;
      vec4 far_z = (vec4((z >> (16u - g.shift.z)) & 0xffffu) - g.far.z) * g.inverse.z;
      vec4 enter = max(max(near_x, near_y), max(near_z, vec4(0.0)));
      vec4 leave = min(min(far_x, far_y), min(far_z, vec4(hit.t))) * kFarther;
      bvec4 met = lessThanEqual(enter, leave);

      // Leaves at once into the mask of primitives to test.
      uint leaf = (met.x ? links.z & 0xffffu : 0u) | (met.y ? links.z >> 16u : 0u) |
                  (met.z ? links.w & 0xffffu : 0u) | (met.w ? links.w >> 16u : 0u);
      mask |= visiting ? leaf : 0u;
      first = visiting && leaf != 0u ? links.y : first;

      // Inner children, nearest first: sorted as ints, the slot in the two lowest bits of the distance.
      uint inner = links.x & 0xfu;
      const int kMiss = 0x7fffffff;
      ivec4 key = (floatBitsToInt(enter) & ~3) | ivec4(0, 1, 2, 3);
      key.x = met.x && (inner & 1u) != 0u ? key.x : kMiss;
      key.y = met.y && (inner & 2u) != 0u ? key.y : kMiss;
      key.z = met.z && (inner & 4u) != 0u ? key.z : kMiss;
      key.w = met.w && (inner & 8u) != 0u ? key.w : kMiss;
      uint found = uint(key.x != kMiss) + uint(key.y != kMiss) + uint(key.z != kMiss) + uint(key.w != kMiss);
      ivec2 low = min(key.xy, key.zw);
      ivec2 high = max(key.xy, key.zw);
      int k0 = min(low.x, low.y);
      int middle0 = max(low.x, low.y);
      int middle1 = min(high.x, high.y);
      int k3 = max(high.x, high.y);
      int k1 = min(middle0, middle1);
      int k2 = max(middle0, middle1);
      uint base = links.x >> 4u;
      uint siblings = base << 8u | (uint(k1) & 3u) << 2u | (uint(k2) & 3u) << 4u | (uint(k3) & 3u) << 6u | (found - 1u);

      // Down to the nearest child, the others onto the stack; or up to the next sibling of the top group.
      bool push = visiting && found > 1u;
      bool pop = visiting && found == 0u;
      uint top = s0;
      uint left = top & 3u;
      bool drop = pop && left <= 1u;
      uint kept = s1;
      uint shorter = (top & 0xffffff00u) | ((top & 0xf0u) >> 2u) | (left - 1u);
      STACK_SHIFT
      s0 = push ? siblings : (drop ? kept : (pop ? shorter : top));
      uint up = left == 0u ? kNoNode : (top >> 8u) + ((top >> 2u) & 3u);
      uint down = base + (uint(k0) & 3u);
      node = visiting ? (found == 0u ? up : down) : node;
    } while (node != kNoNode && mask == 0u);
    do {
      bool testing = mask != 0u;
      uint bit = testing ? uint(findLSB(mask)) : 0u;
      mask &= mask - 1u;
      uint slot = first + bit;
      uvec4 w0 = FETCH(primitive_texels, slot * 3u);
      uvec4 w1 = FETCH(primitive_texels, slot * 3u + 1u);
      uvec4 w2 = FETCH(primitive_texels, slot * 3u + 2u);
      vec4 met = meet_triangle(ray, frame, uintBitsToFloat(w0.xyz), uintBitsToFloat(w1.xyz), uintBitsToFloat(w2.xyz));
      if (kHasQuadrics != 0u) {
        bool quadric = (w0.w & kQuadricBit) != 0u;
        float t = meet_quadric(ray, quadric ? w0.w & ~kQuadricBit : 0u, 0.0);
        met = quadric ? vec4(t, 0.0, 0.0, 0.0) : met;
      }
      bool nearer = testing && met.x > 0.0 && met.x < hit.t && w0.w != ray.skip;
      hit.t = nearer ? met.x : hit.t;
      hit.slot = nearer ? slot : hit.slot;
      hit.weights = nearer ? met.yzw : hit.weights;
      if (any) {
        mask = nearer ? 0u : mask;
        node = nearer ? kNoNode : node;
      }
    } while (mask != 0u);
  } while (node != kNoNode);
  return hit;
}
