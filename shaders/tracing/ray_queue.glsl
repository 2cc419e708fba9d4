// Any hit for many rays of a subgroup: when some lanes are done, they take the next rays of the subgroup's queue instead of waiting
// for the longest of all walks (Aila and Laine 2009, persistent threads). What a ray meets does not depend on the lane it falls to,
// so that no bit of an image does.
//
// For lanes that run in step, where there is no jump forwards: code is passed over only by a loop inside that goes on without it. So
// rays begin outside the loop over rounds. All lanes stay in every loop here until the whole subgroup leaves it.

// The kernel's: the ray of a number in the queue; what became of it (called in all lanes, `answered`: this one has an answer).
Ray queued_ray(uint number);
void queued_answer(uint number, Ray ray, bool hit, bool answered);

layout(constant_id = kSpecQueue) const uint kQueue = 0u;
layout(set = 0, binding = kBindQueue, std430) buffer Queue { uint queue_next[]; };

// Fewer lanes than that are not worth another round of all (docs/tracer.md has what was measured): so many may still look for a leaf
// when the others test, or test when the others go on; so many must be done before rays begin.
const uint kFewNodes = 1u, kFewTests = 2u, kStartLanes = 3u;
const uint kNoRay = 0xffffffffu;

Ray choose(bool take, Ray a, Ray b) {
  b.origin = take ? a.origin : b.origin;
  b.direction = take ? a.direction : b.direction;
  b.t_max = take ? a.t_max : b.t_max;
  b.skip = take ? a.skip : b.skip;
  return b;
}

// How many lanes up to this one want it.
uint rank_among(bool wants) {
  uint lane = gl_SubgroupInvocationID, last = gl_SubgroupSize - 1u;
  uint rank = wants ? 1u : 0u;
  uint below1 = subgroupShuffle(rank, (lane - 1u) & last);
  rank += lane >= 1u ? below1 : 0u;
  uint below2 = subgroupShuffle(rank, (lane - 2u) & last);
  rank += lane >= 2u ? below2 : 0u;
  uint below4 = subgroupShuffle(rank, (lane - 4u) & last);
  rank += lane >= 4u ? below4 : 0u;
  uint below8 = subgroupShuffle(rank, (lane - 8u) & last);
  return rank + (lane >= 8u ? below8 : 0u);
}

// Rays begin ... end - 1, the same in all lanes. An invocation ends silently after 65,535 iterations of all its loops
// (CONTRIBUTING, "Shaders on lavapipe"): after `enough` of them no more rays begin. Returns the first that did not.
uint occluded_rays(uint begin, uint end, uint enough, TreeConstants tree) {
  uint next = begin;  // no lane has taken this one
  uint iterations = 0u;
  Ray ray;
  ray.origin = vec3(0.0);
  ray.direction = vec3(0.0, 0.0, 1.0);
  ray.t_max = -1.0;
  ray.skip = kNoPrimitive;
  uint number = kNoRay;  // of the ray that this lane walks with
  Place place = world_place(ray, tree, true);
  Levels levels = Levels(0u, 0u, kNoNode);
  bool hit = false;
  STACK
  uint node = kNoNode;
  PENDING
  float zero = min(abs(uintBitsToFloat(begin)), 0.0);  // no constant, so that maxima with it stay one instruction
  while (true) {
    bool done = node == kNoNode && mask == 0u;
    queued_answer(number, ray, hit, done && number != kNoRay);
    end = iterations > enough ? next : end;
    uint mine = next + rank_among(done) - 1u;
    bool start = done && mine < end;
    number = done ? (start ? mine : kNoRay) : number;
    next = min(next + lanes_with(done), end);
    if (lanes_with(number != kNoRay) == 0u) break;
    ray = choose(start, queued_ray(start ? mine : begin), ray);
    place = choose(start, world_place(ray, tree, true), place);
    levels.mask = start ? 0u : levels.mask;
    STACK_CLEAR(start)
    hit = hit && !start;
    node = start ? 0u : node;
    bool more = next < end;
    uint few_nodes = more ? kFewNodes : 0u;
    uint few_tests = more ? kFewTests : 0u;
    uint enough_done = more ? kStartLanes : gl_SubgroupSize;
    do {
      do {
        VISIT_ANY
        ++iterations;
      } while (lanes_with(is_node(node) && mask == 0u && !STACK_FULL) > few_nodes);
      if (kInstances != 0u) take_instances(levels, place, first, mask);
      do {
        TEST_ANY
        ++iterations;
      } while (lanes_with(CAN_TEST) > few_tests);
      TEST_ANY_QUADRICS
      NEXT_ROUND_ANY
    } while (lanes_with(node == kNoNode && mask == 0u) < enough_done);
  }
  return next;
}

// The rays of this workgroup's part of a dispatch's queue. The host runs the dispatch again, with `resumed`, as long as the first
// word of `queue_next` says that subgroups are not through; the others say where each goes on.
void occluded_queue(uint rays, uint group_rays, uint stride, uint enough, bool resumed, uint first, TreeConstants tree) {
  uint in_group = gl_LocalInvocationIndex / gl_SubgroupSize, in_each = gl_WorkGroupSize.x / gl_SubgroupSize;
  uint group = spread_group(stride);
  uint each = group_rays / in_each;
  uint begin = min(group * group_rays + in_group * each, rays);
  uint end = min(begin + each, rays);
  uint word = 1u + group * in_each + in_group;
  if (resumed) begin = queue_next[word];
  uint next = occluded_rays(first + begin, first + end, enough, tree) - first;
  if (gl_SubgroupInvocationID == 0u) {
    queue_next[word] = next;
    if (next < end) atomicAdd(queue_next[0], 1u);
  }
}
