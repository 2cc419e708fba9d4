#include "points/ccvt_start.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/hash.h"

namespace capcon {

namespace {

enum Stream : std::uint64_t { kShift = 0x63637674, kMirror, kSites, kShuffle };

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

/// Random sites, yet with the same density everywhere: where independent ones are dense, space points must go
/// far to find one with room, and their cells take long to shrink. They are even points, each moved along
/// both axes by the sum of four uniform numbers, 1.2 spacings wide each (0.7 in standard deviation). That
/// leaves less than 1/1000 of the lattice's amplitude. (Scrambled nets, one point a stratum, leave a square
/// grid that the finished points still show.)
std::vector<TorusPoint> random_sites(std::uint32_t sites, std::uint64_t seed) {
  EvenLattice lattice;
  std::vector<TorusPoint> random = placed_points(sites, seed, lattice), sorted(sites);
  const double scale = 1.2 * 0x1p16 / std::sqrt(static_cast<double>(sites));
  const auto moved = [&](std::uint32_t v, std::uint64_t bits) {
    const std::int64_t sum = static_cast<std::int64_t>((bits & 0xffff) + (bits >> 16 & 0xffff) +
                                                       (bits >> 32 & 0xffff) + (bits >> 48)) -
                             2 * 0xffff;
    return v + static_cast<std::uint32_t>(std::llround(static_cast<double>(sum) * scale));
  };
  for (std::uint32_t i = 0; i < sites; ++i) {
    random[i] = {moved(random[i].x, mix64(seed, kSites, 2ull * i)),
                 moved(random[i].y, mix64(seed, kSites, 2ull * i + 1))};
  }
  const std::vector<std::uint32_t> order = hilbert_order(random);  // neighbours near each other in memory
  for (std::uint32_t i = 0; i < sites; ++i) sorted[i] = random[order[i]];
  return sorted;
}

void shuffle(std::vector<TorusPoint>& points, std::uint64_t seed) {
  for (std::uint64_t k = points.size(); k > 1; --k) {  // Fisher and Yates
    std::swap(points[k - 1], points[mix64(seed, kShuffle, k) % k]);
  }
}

/// The sites that have room, in a grid.
class OpenSites {
 public:
  explicit OpenSites(const std::vector<TorusPoint>& sites) : sites_(sites) {
    while (side_ < 1u << 14 && 4ull * side_ * side_ <= sites.size()) side_ *= 2;
    cells_.resize(static_cast<std::size_t>(side_) * side_);
    for (std::uint32_t i = 0; i < sites.size(); ++i)
      cell(column(sites[i].x), column(sites[i].y)).push_back(i);
  }
  /// The nearest to p, found ring by ring. There must be one.
  std::uint32_t nearest(TorusPoint p) const {
    const auto width = static_cast<double>(1ull << 32) / side_;
    double best2 = std::numeric_limits<double>::infinity();
    std::uint32_t best = 0;
    const auto look = [&](std::uint32_t x, std::uint32_t y) {
      for (const std::uint32_t i :
           cells_[static_cast<std::size_t>(y & (side_ - 1)) * side_ + (x & (side_ - 1))]) {
        const double dx = difference(sites_[i].x, p.x), dy = difference(sites_[i].y, p.y);
        if (dx * dx + dy * dy < best2) best2 = dx * dx + dy * dy, best = i;
      }
    };
    const std::uint32_t x = column(p.x), y = column(p.y);
    for (std::uint32_t ring = 0; ring <= side_ / 2 + 1; ++ring) {
      const double safe = (ring - 1.0) * width;  // nothing of this ring is nearer
      if (ring > 1 && safe * safe > best2) break;
      for (std::uint32_t k = 0; k <= 2 * ring; ++k) {
        look(x - ring + k, y - ring);
        if (ring > 0) look(x - ring + k, y + ring);
      }
      for (std::uint32_t k = 1; k < 2 * ring; ++k) {
        look(x - ring, y - ring + k);
        look(x + ring, y - ring + k);
      }
    }
    return best;
  }
  void close(std::uint32_t i) { std::erase(cell(column(sites_[i].x), column(sites_[i].y)), i); }

 private:
  std::uint32_t column(std::uint32_t v) const {
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(v) * side_ >> 32);
  }
  std::vector<std::uint32_t>& cell(std::uint32_t x, std::uint32_t y) {
    return cells_[static_cast<std::size_t>(y) * side_ + x];
  }

  const std::vector<TorusPoint>& sites_;
  std::uint32_t side_ = 1;
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace

CcvtState random_cells(std::uint32_t sites, std::uint32_t capacity, std::uint64_t seed) {
  EvenLattice lattice;
  std::vector<TorusPoint> points = placed_points(static_cast<std::uint64_t>(sites) * capacity, seed, lattice);
  shuffle(points, seed);
  const std::vector<TorusPoint> places = random_sites(sites, seed);
  OpenSites open(places);
  std::vector<TorusPoint> owned(points.size());
  std::vector<std::uint32_t> filled(sites, 0);
  for (const TorusPoint& p : points) {
    const std::uint32_t i = open.nearest(p);
    owned[static_cast<std::size_t>(i) * capacity + filled[i]++] = p;
    if (filled[i] == capacity) open.close(i);
  }
  return {CcvtCells(capacity, owned), lattice};
}

namespace {

CcvtState split_in_four(const CcvtState& coarse) {
  const EvenLattice fine = coarse.lattice.halved();
  const auto step = [](double v) { return static_cast<std::uint32_t>(std::llround(v * 0x1p32)); };
  TorusPoint offsets[4];
  for (int k = 0; k < 4; ++k) {
    const glm::dvec2 offset = (k / 2 - 0.5) * fine.a + (k % 2 - 0.5) * fine.b;
    offsets[k] = {step(offset.x), step(offset.y)};
  }
  const std::size_t count = coarse.cells.size() * coarse.cells.capacity();
  std::vector<std::uint32_t> x(4 * count), y(4 * count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint32_t px = coarse.cells.x(0)[k], py = coarse.cells.y(0)[k];
    for (std::size_t part = 0; part < 4; ++part) {
      x[4 * k + part] = px + offsets[part].x;
      y[4 * k + part] = py + offsets[part].y;
    }
  }
  return {CcvtCells(4 * coarse.cells.capacity(), std::move(x), std::move(y)), fine};
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
