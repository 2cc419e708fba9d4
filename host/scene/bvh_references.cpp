#include "scene/bvh_references.h"

#include <bit>
#include <cmath>

#include "layout.h"

namespace capcon {
namespace {

float rounded_down(double v) {
  const auto f = static_cast<float>(v);
  return f > v ? std::nextafter(f, -3e38f) : f;
}

float rounded_up(double v) {
  const auto f = static_cast<float>(v);
  return f < v ? std::nextafter(f, 3e38f) : f;
}

/// A polygon of at most five corners: a triangle cut by two planes.
struct Polygon {
  double corner[8][3];
  int count = 0;

  /// Keeps what lies on the side of the plane that `sign` points to.
  void keep(int axis, double plane, double sign) {
    Polygon out;
    for (int i = 0; i < count; ++i) {
      const double* a = corner[i];
      const double* b = corner[(i + 1) % count];
      const double da = sign * (a[axis] - plane), db = sign * (b[axis] - plane);
      if (da >= 0) std::copy(a, a + 3, out.corner[out.count++]);
      if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
        const double t = da / (da - db);
        for (int c = 0; c < 3; ++c) out.corner[out.count][c] = a[c] + t * (b[c] - a[c]);
        out.corner[out.count++][axis] = plane;
      }
    }
    *this = out;
  }
};

}  // namespace

Reference make_reference(const Box& box, std::uint32_t primitive) {
  Reference r{};
  for (int a = 0; a < 3; ++a) {
    r.low[a] = rounded_down(box.low[a]);
    r.high[a] = rounded_up(box.high[a]);
  }
  r.primitive = primitive;
  return r;
}

bool Cutter::corners(std::uint32_t primitive, float (&out)[3][3]) const {
  const glm::uvec4* texel = &texels_[3 * std::size_t(primitive)];
  for (int k = 0; k < 3; ++k) {
    for (int a = 0; a < 3; ++a) out[k][a] = std::bit_cast<float>(texel[k][a]);
  }
  return (texel[0].w & layout::kQuadricBit) == 0;
}

bool Cutter::cut(const Reference& r, int axis, float from, float to, Reference& part) const {
  part = r;
  part.low[axis] = std::max(r.low[axis], from);
  part.high[axis] = std::min(r.high[axis], to);
  if (part.low[axis] > part.high[axis]) return false;
  float v[3][3];
  if (!corners(r.primitive, v)) return true;
  Polygon polygon;
  for (auto& corner : v) std::copy(corner, corner + 3, polygon.corner[polygon.count++]);
  polygon.keep(axis, from, 1);
  polygon.keep(axis, to, -1);
  if (polygon.count == 0) return false;
  for (int a = 0; a < 3; ++a) {
    double low = 1e300, high = -1e300;
    for (int i = 0; i < polygon.count; ++i) {
      low = std::min(low, polygon.corner[i][a]);
      high = std::max(high, polygon.corner[i][a]);
    }
    part.low[a] = std::max(part.low[a], rounded_down(low));
    part.high[a] = std::min(part.high[a], rounded_up(high));
    if (part.low[a] > part.high[a]) return false;
  }
  return true;
}

}  // namespace capcon
