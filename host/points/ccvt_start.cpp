#include "points/ccvt_start.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/hash.h"

namespace capcon {

namespace {

enum Stream : std::uint64_t { kShift = 0x63637674, kMirror, kCut, kSeam };

/// Even space points, mirrored and shifted at random: no set of sites has a preferred place or direction.
std::vector<TorusPoint> placed_points(std::uint64_t m, std::uint64_t seed, EvenLattice& lattice) {
  const RankOne rank_one = even_lattice(m);
  lattice = rank_one.lattice;
  std::vector<TorusPoint> points = points_of(rank_one);
  const std::uint64_t shift = mix64(seed, kShift, m), mirror = mix64(seed, kMirror, m);
  const auto place_vector = [&](glm::dvec2& v) {
    if (mirror & 1) v.x = -v.x;
    if (mirror & 2) std::swap(v.x, v.y);
  };
  place_vector(lattice.a);
  place_vector(lattice.b);
  for (TorusPoint& p : points) {
    if (mirror & 1) p.x = 0 - p.x;
    if (mirror & 2) std::swap(p.x, p.y);
    p.x += static_cast<std::uint32_t>(shift >> 32);
    p.y += static_cast<std::uint32_t>(shift);
  }
  return points;
}

/// The direction of greatest extent of a range of points, turned by a random angle: parts stay compact, yet
/// no two starts nor two parts are alike.
struct Direction {
  double x, y;
};
Direction cut_direction(const TorusPoint* points, std::size_t count, double random) {
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0, yy = 0;
  for (std::size_t k = 0; k < count; ++k) {
    mean_x += points[k].x;
    mean_y += points[k].y;
  }
  mean_x /= static_cast<double>(count);
  mean_y /= static_cast<double>(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double dx = points[k].x - mean_x, dy = points[k].y - mean_y;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
  const double angle = 0.5 * std::atan2(2 * xy, xx - yy) + 1.5 * (random - 0.5);
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

CcvtState random_cells(std::uint32_t sites, std::uint32_t capacity, std::uint64_t seed) {
  EvenLattice lattice;
  std::vector<TorusPoint> points = placed_points(static_cast<std::uint64_t>(sites) * capacity, seed, lattice);
  // The torus is cut open anywhere, then put back.
  const std::uint64_t seam = mix64(seed, kSeam, 0);
  const auto move = [&](std::uint32_t x, std::uint32_t y) {
    for (TorusPoint& p : points) p = {p.x + x, p.y + y};
  };
  const auto seam_x = static_cast<std::uint32_t>(seam >> 32), seam_y = static_cast<std::uint32_t>(seam);
  move(seam_x, seam_y);
  struct Part {
    std::uint32_t first, sites;
    std::uint64_t name;  ///< as in a heap: the address of its random number
  };
  std::vector<Part> parts{{0, sites, 1}};
  while (!parts.empty()) {
    const Part part = parts.back();
    parts.pop_back();
    if (part.sites == 1) continue;
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(part.first) * capacity;
    const std::size_t count = static_cast<std::size_t>(part.sites) * capacity;
    const std::uint32_t half = part.sites / 2;
    const Direction u = cut_direction(&*begin, count, uniform64(seed, kCut, part.name));
    std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(half) * capacity,
                     begin + static_cast<std::ptrdiff_t>(count),
                     [&](const TorusPoint& a, const TorusPoint& b) {
                       const double ka = a.x * u.x + a.y * u.y, kb = b.x * u.x + b.y * u.y;
                       return ka != kb ? ka < kb : a.x != b.x ? a.x < b.x : a.y < b.y;
                     });
    parts.push_back({part.first, half, 2 * part.name});
    parts.push_back({part.first + half, part.sites - half, 2 * part.name + 1});
  }
  move(0 - seam_x, 0 - seam_y);
  return {CcvtCells(capacity, points), lattice};
}

namespace {

CcvtState split_in_four(const CcvtState& coarse) {
  const EvenLattice fine = coarse.lattice.halved();
  const auto step = [](double v) { return static_cast<std::uint32_t>(std::llround(v * 0x1p32)); };
  std::vector<TorusPoint> points;
  const std::size_t count = coarse.cells.size() * coarse.cells.capacity();
  points.reserve(4 * count);
  for (std::size_t k = 0; k < count; ++k) {
    const TorusPoint p{coarse.cells.x(0)[k], coarse.cells.y(0)[k]};
    for (const double u : {-0.5, 0.5}) {
      for (const double v : {-0.5, 0.5}) {
        const glm::dvec2 offset = u * fine.a + v * fine.b;
        points.push_back({p.x + step(offset.x), p.y + step(offset.y)});
      }
    }
  }
  return {CcvtCells(4 * coarse.cells.capacity(), points), fine};
}

}  // namespace

CcvtState refined_cells(const CcvtState& coarse, std::uint32_t capacity, std::uint64_t seed) {
  const CcvtCells& cells = coarse.cells;
  const std::uint64_t old_capacity = cells.capacity();
  if (capacity == 4 * old_capacity) return split_in_four(coarse);
  std::vector<std::uint32_t> owner;  // of the old space points, in the order of a Hilbert curve
  {
    std::vector<TorusPoint> old(cells.size() * old_capacity);
    for (std::size_t k = 0; k < old.size(); ++k) old[k] = {cells.x(0)[k], cells.y(0)[k]};
    owner = hilbert_order(old);
    for (std::uint32_t& k : owner) k = static_cast<std::uint32_t>(k / old_capacity);
  }
  // Walk along the curve over both sets: each old point hands its owner its share of new points. The k-th
  // point of a site hands over floor((k+1) r) - floor(k r), r = new / old capacity, which adds up to the new
  // capacity exactly.
  EvenLattice lattice;
  const std::vector<TorusPoint> fresh =
      placed_points(cells.size() * static_cast<std::uint64_t>(capacity), seed, lattice);
  const std::vector<std::uint32_t> order = hilbert_order(fresh);
  std::vector<TorusPoint> points(fresh.size());
  std::vector<std::uint32_t> handed(cells.size(), 0), filled(cells.size(), 0);
  std::size_t next = 0;
  for (const std::uint32_t site : owner) {
    const std::uint64_t until = ++handed[site] * static_cast<std::uint64_t>(capacity) / old_capacity;
    while (filled[site] < until)
      points[static_cast<std::size_t>(site) * capacity + filled[site]++] = fresh[order[next++]];
  }
  return {CcvtCells(capacity, points), lattice};
}

}  // namespace capcon
