// The tree: nodes of four children in 64 bytes, four texels each (host/scene/bvh.h): the x, y and z extents of the children
// as centre and half extent of 16 bits each, then children, first primitive and primitive masks.
//
// Written for lanes that run in step (docs/tracer.md): no branches but loops; loops test at the bottom; every value that is
// read after a loop is carried through it, never simply set in it (CONTRIBUTING, "Shaders on lavapipe").
DATA_TEXELS(kBindNodes, node_texels);
DATA_TEXELS(kBindPrimitives, primitive_texels);

#include "tracing/ray.glsl"
#include "tracing/triangle.glsl"
#include "tracing/quadric.glsl"
#include "tracing/instances.glsl"
#include "tracing/lanes.glsl"
#include "tracing/stack.glsl"

struct Hit {
  float t;
  uint slot;      // of the primitive in leaf order; kNoPrimitive: nothing was met
  uint instance;  // its slot, where there are two levels
  vec3 weights;
};

const float kFarther = 1.0000012;  // the reach's share of the rounding of a box's distance

vec4 later(vec4 a, vec4 b) { return mix(b, a, greaterThan(a, b)); }
vec4 sooner(vec4 a, vec4 b) { return mix(b, a, lessThan(a, b)); }

// The id of what was hit, counted over all instances.
uint hit_id(Hit hit) {
  if (hit.slot == kNoPrimitive) return kNoPrimitive;
  uint id = FETCH(primitive_texels, hit.slot * 3u).w;
  if (kInstances != 0u) id += FETCH(instance_texels, hit.instance * 8u + 4u).w;
  return id;
}

// Groups of siblings that wait, unsorted: first sibling << 4 | the slots that are left. The sentinel has none.
const uint kMaskSentinel = 1u << 4u;
uint mask_rest(uint group) { return group & (group - 1u); }  // of a group with slots left
uint mask_node(uint group) {
  uint lowest = group & (0u - group) & 15u;
  return lowest == 0u ? ~(group >> 4u) : (group >> 4u) + (lowest >> 1u) - (lowest >> 3u);
}

// What the extents of a node's four children say: `enter`, where the ray gets into each box, and `met`. Half of the multiply,
// subtract and compare of a test by planes is shared by both planes.
#define MEET_BOXES(g, x, y, z, reach) \
  vec4 cx = (vec4(ivec4(x)) - g.origin.x) * g.inverse.x; \
  vec4 cy = (vec4(ivec4(y)) - g.origin.y) * g.inverse.y; \
  vec4 cz = (vec4(ivec4(z)) - g.origin.z) * g.inverse.z; \
  vec4 hx = half_extent(x, g.slack.x) * g.stretch.x; \
  vec4 hy = half_extent(y, g.slack.y) * g.stretch.y; \
  vec4 hz = half_extent(z, g.slack.z) * g.stretch.z; \
  vec4 enter = later(later(cx - hx, cy - hy), later(cz - hz, vec4(zero))); \
  vec4 leave = sooner(sooner(cx + hx, cy + hy), sooner(cz + hz, vec4(reach))); \
  bvec4 met = lessThanEqual(enter, leave);

vec4 half_extent(uvec4 word, float slack) {
  vec4 half_cells = vec4(ivec4(word & 0xffffu));
  return kInstances != 0u ? half_cells + slack : half_cells;
}

// Leaves that a lane has found and not yet tested: primitives first + bit, and first1 + bit of the next one. While other lanes
// look for their first leaf, it goes on to its second (speculative traversal: Aila and Laine 2009).
#define PENDING \
  uint first = 0u, mask = 0u; \
  uint first1 = 0u, mask1 = 0u; \
  uint quadric = kNoPrimitive;  /* the id of the first one's next primitive, if that is none of a triangle */

#define PENDING_ADD(leaf, at_slot) \
  { \
    bool second = mask != 0u; \
    mask1 = second ? mask1 | leaf : mask1; \
    first1 = second && leaf != 0u ? at_slot : first1; \
    first = second ? first : at_slot; \
    mask = second ? mask : leaf; \
  }

// After a test: what is left of the first leaf, or the second in its place.
#define PENDING_NEXT \
  { \
    bool next = mask == 0u; \
    first = next ? first1 : first; \
    mask = next ? mask1 : mask; \
    mask1 = next ? 0u : mask1; \
  }

// Whether a lane has a node to visit and room for what it finds. In the tree of instances it waits with its first leaf.
#define CAN_VISIT \
  (is_node(node) && mask1 == 0u && !STACK_FULL && (kInstances == 0u || mask == 0u || place.instance != kNoNode))

// One node of a walk that asks for any hit. Which child comes first hardly matters here, so that nothing is sorted.
#define VISIT_ANY \
  { \
    bool run = CAN_VISIT; \
    uint at = (run ? node : 0u) * 4u; \
    uvec4 x = FETCH(node_texels, at); \
    uvec4 y = FETCH(node_texels, at + 1u); \
    uvec4 z = FETCH(node_texels, at + 2u); \
    uvec4 links = FETCH(node_texels, at + 3u); \
    float reach = place.ray.t_max * kFarther; \
    MEET_BOXES(place.grid, x, y, z, reach) \
    uint leaf = (met.x ? links.z & 0xffffu : 0u) | (met.y ? links.z >> 16u : 0u) | \
                (met.z ? links.w & 0xffffu : 0u) | (met.w ? links.w >> 16u : 0u); \
    uint inner = ((met.x ? 1u : 0u) | (met.y ? 2u : 0u) | (met.z ? 4u : 0u) | (met.w ? 8u : 0u)) & links.x; \
    leaf = run ? leaf : 0u; \
    PENDING_ADD(leaf, links.y) \
    bool pop = inner == 0u; \
    uint group = pop ? s0 : (links.x & ~15u) | inner; \
    uint rest = mask_rest(group); \
    bool more = (rest & 15u) != 0u; \
    bool push = run && !pop && more;  /* what is left of the children goes on top */ \
    bool drop = run && pop && !more;  /* the top group is used up */ \
    bool keep = run && pop && more; \
    STACK_MOVE(push, rest, drop, keep, rest) \
    node = run ? mask_node(group) : node; \
  }

// One primitive of each lane that has found some: `met` is what the ray says to a triangle, `nearer` whether it counts. A sphere or
// disk is left to MEET_QUADRICS, and its lane with it: there is no jump over code that only some lanes need, and a test of a
// quadric takes as long as one of a triangle.
#define MEET_TRIANGLES \
  bool testing = mask != 0u && quadric == kNoPrimitive; \
  uint slot = first + (testing ? uint(findLSB(mask)) : 0u); \
  uvec4 w0 = FETCH(primitive_texels, slot * 3u); \
  uvec4 w1 = FETCH(primitive_texels, slot * 3u + 1u); \
  uvec4 w2 = FETCH(primitive_texels, slot * 3u + 2u); \
  if (kHasQuadrics != 0u) { \
    bool other = testing && (w0.w & kQuadricBit) != 0u; \
    quadric = other ? w0.w : quadric; \
    testing = testing && !other; \
  } \
  vec4 met = meet_triangle(place.ray, place.frame, uintBitsToFloat(w0.xyz), uintBitsToFloat(w1.xyz), uintBitsToFloat(w2.xyz)); \
  bool nearer = testing && met.x > 0.0 && met.x < place.ray.t_max && counts(ray, w0.w + place.first_id); \
  mask &= kHasQuadrics == 0u || testing ? mask - 1u : mask;

#define CAN_TEST (mask != 0u && quadric == kNoPrimitive)

// The same for the sphere or disk that a lane waits with.
#define MEET_QUADRICS \
  bool testing = quadric != kNoPrimitive; \
  uint slot = first + (testing ? uint(findLSB(mask)) : 0u); \
  float t = meet_quadric(place.ray, testing ? quadric & ~kQuadricBit : 0u, 0.0); \
  bool nearer = testing && t > 0.0 && t < place.ray.t_max && counts(ray, quadric + place.first_id); \
  mask &= testing ? mask - 1u : mask; \
  quadric = kNoPrimitive;

// What that means to a walk for any hit.
#define TAKE_ANY \
  hit = hit || nearer; \
  mask1 = nearer ? 0u : mask1; \
  mask = nearer ? 0u : mask; \
  PENDING_NEXT

#define TEST_ANY { MEET_TRIANGLES TAKE_ANY }
#define TEST_ANY_QUADRICS if (kHasQuadrics != 0u) { MEET_QUADRICS TAKE_ANY }

// Between rounds of a walk for any hit: a lane whose registers are full or empty moves entries to or from the array, and may
// change the level. One that has a hit is done.
#define NEXT_ROUND_ANY \
  { \
    STACK_SPILL \
    node = hit ? kNoNode : node; \
    waiting_count = hit ? 0u : waiting_count; \
    bool refill = node == kNoNode && waiting_count != 0u; \
    waiting_count -= refill ? 1u : 0u; \
    uint group = refill ? waiting[waiting_count] : 0u; \
    uint rest = mask_rest(group); \
    s0 = refill && (rest & 15u) != 0u ? rest : s0; \
    node = refill ? mask_node(group) : node; \
    if (kInstances != 0u) { \
      bool push = switch_level(levels, place, node, ray, tree, mask == 0u); \
      STACK_PUSH(push, kMaskSentinel) \
    } \
  }

// Whether a ray that starts within the scene's bounds meets anything.
bool occluded(Ray ray, TreeConstants tree, bool live) {
  ray.t_max = live ? ray.t_max : -1.0;  // a lane without a ray leaves the root at once
  Place place = world_place(ray, tree, true);
  Levels levels = Levels(0u, 0u, kNoNode);
  bool hit = false;
  STACK
  uint node = 0u;
  PENDING
  float zero = min(abs(ray.direction.x), 0.0);  // no constant, so that maxima with it stay one instruction
  do {
    do VISIT_ANY while (any_lane(is_node(node) && mask == 0u && !STACK_FULL));
    if (kInstances != 0u) take_instances(levels, place, first, mask);
    do TEST_ANY while (any_lane(CAN_TEST));
    TEST_ANY_QUADRICS
    NEXT_ROUND_ANY
  } while (any_lane(node != kNoNode || mask != 0u));
  return hit;
}

// Groups sorted by distance: first sibling << 8 | three 2-bit slots, nearest lowest | count. The sentinel counts none.
const uint kListSentinel = 1u << 8u;
uint list_rest(uint group) {
  uint left = group & 3u;
  return left <= 1u ? 0u : (group & 0xffffff00u) | ((group & 0xf0u) >> 2u) | (left - 1u);
}
uint list_node(uint group) { return (group & 3u) == 0u ? ~(group >> 8u) : (group >> 8u) + ((group >> 2u) & 3u); }

// What a primitive that is nearer means to a walk for the closest.
#define TAKE_CLOSEST(weights_met) \
  hit.slot = nearer ? slot : hit.slot; \
  if (kInstances != 0u) { \
    hit.t = nearer ? place.ray.t_max / place.scale : hit.t; \
    hit.instance = nearer ? place.instance : hit.instance; \
  } \
  hit.weights = nearer ? weights_met : hit.weights; \
  PENDING_NEXT

// The nearest primitive that a ray from anywhere meets.
Hit closest(Ray ray, TreeConstants tree, bool live) {
  ray.t_max = live ? ray.t_max : -1.0;  // a lane without a ray leaves the root at once; the reach from here on
  Place place = world_place(ray, tree, false);
  Levels levels = Levels(0u, 0u, kNoNode);
  Hit hit = Hit(ray.t_max, kNoPrimitive, 0u, vec3(0.0));
  STACK
  uint node = 0u;
  PENDING
  float zero = min(abs(ray.direction.x), 0.0);  // no constant, so that maxima with it stay one instruction
  do {
    do {
      bool run = CAN_VISIT;
      uint at = (run ? node : 0u) * 4u;
      uvec4 x = FETCH(node_texels, at);
      uvec4 y = FETCH(node_texels, at + 1u);
      uvec4 z = FETCH(node_texels, at + 2u);
      uvec4 links = FETCH(node_texels, at + 3u);
      float reach = place.ray.t_max * kFarther;
      MEET_BOXES(place.grid, x, y, z, reach)

      // Leaves at once into the mask of primitives to test.
      uint leaf = (met.x ? links.z & 0xffffu : 0u) | (met.y ? links.z >> 16u : 0u) |
                  (met.z ? links.w & 0xffffu : 0u) | (met.w ? links.w >> 16u : 0u);
      leaf = run ? leaf : 0u;
      PENDING_ADD(leaf, links.y)

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
      bool push = run && found > 1u;
      bool pop = found == 0u;
      uint rest = list_rest(s0);
      uint next_node = pop ? list_node(s0) : base + (uint(k0) & 3u);
      bool drop = run && pop && rest == 0u;
      bool keep = run && pop && rest != 0u;
      STACK_MOVE(push, siblings, drop, keep, rest)
      node = run ? next_node : node;
    } while (any_lane(is_node(node) && mask == 0u && !STACK_FULL));
    if (kInstances != 0u) take_instances(levels, place, first, mask);
    do {
      MEET_TRIANGLES
      place.ray.t_max = nearer ? met.x : place.ray.t_max;
      TAKE_CLOSEST(met.yzw)
    } while (any_lane(CAN_TEST));
    if (kHasQuadrics != 0u) {
      MEET_QUADRICS
      place.ray.t_max = nearer ? t : place.ray.t_max;
      TAKE_CLOSEST(vec3(0.0))
    }
    STACK_SPILL
    bool refill = node == kNoNode && waiting_count != 0u;
    waiting_count -= refill ? 1u : 0u;
    uint group = refill ? waiting[waiting_count] : 0u;
    s0 = refill ? list_rest(group) : s0;
    node = refill ? list_node(group) : node;
    if (kInstances != 0u) {
      Ray world = ray;
      world.t_max = hit.t;
      bool push = switch_level(levels, place, node, world, tree, mask == 0u);
      STACK_PUSH(push, kListSentinel)
    }
  } while (any_lane(node != kNoNode || mask != 0u));
  if (kInstances == 0u) hit.t = place.ray.t_max;
  return hit;
}
