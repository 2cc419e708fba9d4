#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "scene/bvh.h"

namespace capcon {

/// A box of floats with the number of boxes that it holds.
struct FloatBox {
  float low[4] = {3e38f, 3e38f, 3e38f, 0};  ///< the fourth of each means nothing: four are one vector
  float high[4] = {-3e38f, -3e38f, -3e38f, 0};

  /// A FloatBox or a Reference.
  template <class AnyBox>
  void add(const AnyBox& b) {
#ifdef __SSE2__
    _mm_storeu_ps(low, _mm_min_ps(_mm_loadu_ps(b.low), _mm_loadu_ps(low)));
    _mm_storeu_ps(high, _mm_max_ps(_mm_loadu_ps(b.high), _mm_loadu_ps(high)));
#else
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], b.low[a]);
      high[a] = std::max(high[a], b.high[a]);
    }
#endif
  }
  /// Half the surface; 0 for an empty box.
  double half_area() const {
    const double x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    return x < 0 || y < 0 || z < 0 ? 0 : x * y + y * z + z * x;
  }
};

/// A primitive, or the part of it in a box: what the builder sorts into a tree. Rounded outward.
struct Reference {
  float low[4], high[4];  ///< as in FloatBox
  std::uint32_t primitive = 0;

  float centre(int axis) const { return 0.5f * (low[axis] + high[axis]); }
};

Reference make_reference(const Box& box, std::uint32_t primitive);

/// Triangles that may be cut, three texels a primitive as Geometry holds them: corners as float bits; a word
/// with kQuadricBit behind the first marks what is no triangle, of which only the box is cut.
class Cutter {
 public:
  explicit Cutter(std::span<const glm::uvec4> texels) : texels_(texels) {}
  bool empty() const { return texels_.empty(); }

  /// The bounds of the reference's part between two planes of an axis; false if there is none.
  bool cut(const Reference& reference, int axis, float from, float to, Reference& part) const;

  /// Adds the bounds of the parts between planes first, first + 1, ... last + 1 of an axis to one box each,
  /// to float precision: for costs. `plane(i)` gives plane i.
  template <class Plane>
  void add_parts(const Reference& reference, int axis, int first, int last, const Plane& plane,
                 FloatBox* boxes) const;

 private:
  bool corners(std::uint32_t primitive, float (&out)[3][3]) const;

  std::span<const glm::uvec4> texels_;
};

template <class Plane>
void Cutter::add_parts(const Reference& r, int axis, int first, int last, const Plane& plane,
                       FloatBox* boxes) const {
  float v[3][3];
  const bool triangle = corners(r.primitive, v);
  const auto low = [&](int b) { return b == first ? r.low[axis] : plane(b); };
  const auto high = [&](int b) { return b == last ? r.high[axis] : plane(b + 1); };
  for (int b = first; b <= last; ++b) {
    FloatBox part;
    if (!triangle) part.add(r);
    for (int k = 0; triangle && k < 3; ++k) {
      const float* p = v[k];
      const float* q = v[(k + 1) % 3];
      if (p[axis] > q[axis]) std::swap(p, q);
      if (q[axis] < low(b) || p[axis] > high(b)) continue;
      // The edge's two ends within the slab.
      for (const float at : {std::max(p[axis], low(b)), std::min(q[axis], high(b))}) {
        const float t = q[axis] > p[axis] ? (at - p[axis]) / (q[axis] - p[axis]) : 0.0f;
        for (int a = 0; a < 3; ++a) {
          const float x = p[a] + t * (q[a] - p[a]);
          part.low[a] = std::min(part.low[a], x);
          part.high[a] = std::max(part.high[a], x);
        }
      }
    }
    part.low[axis] = low(b);
    part.high[axis] = high(b);
    bool some = true;
    for (int a = 0; a < 3; ++a) {
      part.low[a] = std::max(part.low[a], r.low[a]);
      part.high[a] = std::min(part.high[a], r.high[a]);
      some = some && part.low[a] <= part.high[a];
    }
    if (some) boxes[b].add(part);
  }
}

}  // namespace capcon
