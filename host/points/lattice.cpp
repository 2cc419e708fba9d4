#include "points/lattice.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

namespace capcon {

std::array<glm::i64vec2, 2> reduced_basis(std::uint64_t m, std::uint64_t g) {
  // Lagrange-Gauss reduction in 128 bits: products of m < 2^32.
  __extension__ using Wide = __int128;
  Wide ax = 0, ay = static_cast<Wide>(m), bx = 1, by = static_cast<Wide>(g);
  const auto norm = [](Wide x, Wide y) { return x * x + y * y; };
  for (;;) {
    if (norm(ax, ay) < norm(bx, by)) std::swap(ax, bx), std::swap(ay, by);
    const Wide b2 = norm(bx, by), dot = ax * bx + ay * by;
    const Wide quotient = (2 * dot + (dot >= 0 ? b2 : -b2)) / (2 * b2);  // the nearest multiple of b
    if (quotient == 0) break;
    const Wide cx = ax - quotient * bx, cy = ay - quotient * by;
    if (norm(cx, cy) >= norm(ax, ay)) break;
    ax = cx;
    ay = cy;
  }
  const auto vector = [](Wide x, Wide y) {
    return glm::i64vec2(static_cast<std::int64_t>(x), static_cast<std::int64_t>(y));
  };
  return {vector(bx, by), vector(ax, ay)};
}

RankOne even_lattice(std::uint64_t m) {
  // Candidates about the golden section's multiple and, for an even choice, at a fixed stride through the
  // rest.
  RankOne best{{m, {1, 0}, {0, 1}}, 0};
  double best2 = 0;
  const auto consider = [&](std::uint64_t g) {
    if (g == 0 || g >= m || std::gcd(g, m) != 1) return;
    const auto basis = reduced_basis(m, g);
    const glm::dvec2 a(basis[0]), b(basis[1]);
    if (glm::dot(a, a) <= best2) return;
    best2 = glm::dot(a, a);
    best = {{m, a / static_cast<double>(m), b / static_cast<double>(m)}, g};
  };
  const std::uint64_t stride = std::max<std::uint64_t>(1, m / 2048);
  for (std::uint64_t g = 1; g < m / 2 + 2; g += stride) consider(g);
  const auto golden = static_cast<std::uint64_t>(static_cast<double>(m) * 0.6180339887498949);
  for (std::uint64_t k = 0; k < 32; ++k) consider(golden + k - 16);
  return best;
}

std::vector<TorusPoint> points_of(const RankOne& lattice) {
  const std::uint64_t m = lattice.lattice.m;
  std::vector<TorusPoint> points(m);
  std::uint64_t y = 0;
  for (std::uint64_t k = 0; k < m; ++k) {
    points[k] = {static_cast<std::uint32_t>((k << 32) / m), static_cast<std::uint32_t>((y << 32) / m)};
    y += lattice.g;
    if (y >= m) y -= m;
  }
  return points;
}

namespace {

/// Place along the Hilbert curve of order 16 (the usual quadrant rotations, as a table of four orientations).
std::uint32_t hilbert_key(TorusPoint p) {
  // For orientation s and quadrant 2*(x bit) + (y bit): place of the quadrant, and the orientation inside it.
  static constexpr std::uint8_t kPlace[4][4] = {{0, 1, 3, 2}, {0, 3, 1, 2}, {2, 1, 3, 0}, {2, 3, 1, 0}};
  static constexpr std::uint8_t kNext[4][4] = {{1, 0, 2, 0}, {0, 3, 1, 1}, {2, 2, 0, 3}, {3, 1, 3, 2}};
  std::uint32_t key = 0, state = 0;
  for (int bit = 31; bit >= 16; --bit) {
    const std::uint32_t quadrant = ((p.x >> bit & 1) << 1) | (p.y >> bit & 1);
    key = key << 2 | kPlace[state][quadrant];
    state = kNext[state][quadrant];
  }
  return key;
}

}  // namespace

std::vector<std::uint32_t> hilbert_order(const std::vector<TorusPoint>& points) {
  struct Item {
    std::uint32_t key, index;
  };
  std::vector<Item> items(points.size()), other(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) items[i] = {hilbert_key(points[i]), i};
  for (int shift = 0; shift < 32; shift += 11) {  // radix sort, stable
    std::array<std::uint32_t, 2049> start{};
    for (const Item& item : items) ++start[(item.key >> shift & 2047) + 1];
    for (int digit = 0; digit < 2048; ++digit) start[digit + 1] += start[digit];
    for (const Item& item : items) other[start[item.key >> shift & 2047]++] = item;
    items.swap(other);
  }
  std::vector<std::uint32_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = items[i].index;
  return order;
}

}  // namespace capcon
