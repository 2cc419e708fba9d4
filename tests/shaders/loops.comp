#version 460
#extension GL_GOOGLE_include_directive : require
// Divergent loops whose values are read after them, in the ways that lavapipe gets right (CONTRIBUTING, "Shaders on lavapipe").
// Every thread walks its own number of links of a chain and writes what it found; tests/gpu/loops_test.cpp says what that is.
#include "fetch.glsl"
#include "tracing/lanes.glsl"

layout(local_size_x = 64) in;
layout(constant_id = 0) const uint kPattern = 0u;
DATA_TEXELS(0, chain);  // x: a value, y: the next link, z: 1 where a search ends
layout(set = 0, binding = 1, std430) writeonly buffer Found { uvec4 found[]; };

// How many links a thread walks: 1 ... 61, very uneven among neighbours.
uint length_of(uint thread) { return 1u + (thread * 2654435761u >> 24u) % 61u; }

void main() {
  uint thread = gl_GlobalInvocationID.x;
  uint count = length_of(thread);
  uint link = thread % 997u, value = 0u, steps = 0u, sum = 0u;
  if (kPattern == 0u) {
    // Loop-carried by a choice.
    do {
      uvec4 w = FETCH(chain, link);
      bool odd = (w.x & 1u) != 0u;
      value = odd ? w.x : value;
      sum += w.x;
      link = w.y;
      ++steps;
    } while (steps < count);
  } else if (kPattern == 1u) {
    // Recomputed after the loop from what it carries.
    uint last = link;
    do {
      last = steps + 1u == count ? link : last;
      uvec4 w = FETCH(chain, link);
      sum += w.x;
      link = w.y;
      ++steps;
    } while (steps < count);
    value = FETCH(chain, last).x;
  } else if (kPattern == 2u) {
    // Accumulated.
    do {
      uvec4 w = FETCH(chain, link);
      value |= w.x & ~w.y;
      sum = max(sum, w.x);
      link = w.y;
      ++steps;
    } while (steps < count);
  } else if (kPattern == 3u) {
    // All lanes stay until none of them wants to go on; those that are done change nothing.
    do {
      bool run = steps < count;
      uvec4 w = FETCH(chain, run ? link : 0u);
      value = run ? w.x : value;
      sum += run ? w.x : 0u;
      link = run ? w.y : link;
      steps += run ? 1u : 0u;
    } while (any_lane(steps < count));
  } else if (kPattern == 4u) {
    // Loops in a loop, as a walk has them: what the first finds is used up by the second.
    do {
      uint pending = 0u;
      do {
        uvec4 w = FETCH(chain, link);
        pending |= w.z != 0u ? w.x | 1u : 0u;
        link = w.y;
        ++steps;
      } while (pending == 0u && steps < count);
      do {
        sum += pending & 1u;
        value ^= (pending & 1u) != 0u ? steps * 2654435761u : 0u;
        pending >>= 1u;
      } while (pending != 0u);
    } while (steps < count);
  } else {
    // The most iterations that an invocation may make in all, 65,535, in two loops.
    do {
      sum += link ^ steps;
      ++steps;
    } while (steps < 40000u);
    do {
      value = value * 3u + steps;
      ++steps;
    } while (steps < 65535u);
  }
  // Not `link`: it is set in its loops, not carried, and wrong here for threads that left early.
  found[thread] = uvec4(value, kPattern, steps, sum);
}
