#include "points/region_ccvt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numeric>
#include <utility>

#include "base/error.h"
#include "base/hash.h"
#include "points/ccvt_optimise.h"
#include "points/lattice.h"
#include "points/measure.h"
#include "points/site_tree.h"
#include "points/transport_finish.h"

namespace capcon {

namespace {

enum Stream : std::uint64_t { kShuffle = 0x72636376, kSites, kLevel };

/// To and from the optimiser's coordinates. A bounded region takes the lower left quarter of the torus, and
/// fills it as far as there is mass: differences are below half the period, so nothing wraps around.
class Frame {
 public:
  explicit Frame(const Region& region) {
    if (region.is_plain_torus()) return;
    std::pair<glm::dvec2, glm::dvec2> box{{0, 0}, {1, 1}};
    if (region.density) box = region.density->support();
    const double size = std::max(box.second.x - box.first.x, box.second.y - box.first.y);
    if (region.domain == Domain::kTorus && size > 0.5)
      return;  // else no way around the torus is shorter either
    wraps_ = false;
    low_ = box.first;
    scale_ = 0x1p31 * (1 - 0x1p-40) / size;
  }
  bool wraps() const { return wraps_; }
  TorusPoint to(glm::dvec2 p) const {
    p = (p - low_) * scale_;
    return {static_cast<std::uint32_t>(std::max(p.x, 0.0)), static_cast<std::uint32_t>(std::max(p.y, 0.0))};
  }
  glm::dvec2 from(glm::dvec2 p) const {
    p = p / scale_ + low_;
    if (wraps_) p -= glm::floor(p);
    constexpr double kBelowOne = 1 - 0x1p-53;
    return glm::min(p, glm::dvec2(kBelowOne));
  }

 private:
  bool wraps_ = true;
  double scale_ = 0x1p32;
  glm::dvec2 low_{0};
};

/// Even places, each moved at random by about 0.7 of the spacing: sites without lines or grids (see
/// ccvt_start.cpp), reflected at the sides where these do not meet.
Points random_sites(const Region& region, std::uint32_t n, std::uint64_t seed) {
  if (region.domain == Domain::kDisk && region.density) return random_points(region, n, seed);
  Points places = spread({}, n, seed);
  const double width = 1.2 / std::sqrt(static_cast<double>(n));
  for (std::uint64_t i = 0; i < n; ++i) {
    for (int axis = 0; axis < 2; ++axis) {
      double sum = -2;
      for (std::uint64_t k = 0; k < 4; ++k) sum += uniform64(seed, kSites, 8 * i + 4 * axis + k);
      double v = places[i][axis] + width * sum;
      if (region.domain != Domain::kTorus) v = std::abs(v) > 1 ? 2 - std::abs(v) : std::abs(v);
      v -= std::floor(v);
      places[i][axis] = v < 1 ? v : 0;
    }
  }
  place_all(region, places);
  return places;
}

class RegionOptimiser {
 public:
  RegionOptimiser(const Region& region, const CcvtOptions& options)
      : region_(region), options_(options), frame_(region) {}

  CcvtCells run() {
    std::vector<std::uint32_t> capacities{options_.capacity};
    while (capacities.front() > 16) capacities.insert(capacities.begin(), capacities.front() / 4);
    const double total = std::accumulate(capacities.begin(), capacities.end(), 0.0);
    double done = 0;
    CcvtCells cells = start(capacities.front());
    for (const std::uint32_t capacity : capacities) {
      const bool last = capacity == options_.capacity;
      if (capacity != capacities.front()) cells = refined(cells, capacity);
      double first = 0, part = 0;
      const CcvtEffort effort = optimise(
          cells, last ? CcvtPace{} : coarse_pace(cells.size(), capacity),
          [&](std::uint64_t swaps) {
            if (last && options_.on_pass) options_.on_pass(cells.energy() / kHexagonEnergy, swaps);
            const double left = std::log2(1.0 + static_cast<double>(swaps));
            if (first == 0) first = left;
            if (first > 0) part = std::max(part, 1 - left / first);
            if (options_.on_progress) options_.on_progress((done + part * capacity) / total);
          },
          options_.stop);
      if (effort.stopped) break;
      done += capacity;
    }
    return cells;
  }
  const Frame& frame() const { return frame_; }

 private:
  /// Each space point, in random order, to the nearest site that has room.
  CcvtCells start(std::uint32_t capacity) const {
    const std::uint32_t n = options_.sites;
    Points points = spread(region_, static_cast<std::uint64_t>(n) * capacity, options_.seed);
    for (std::uint64_t k = points.size(); k > 1; --k)  // Fisher and Yates
      std::swap(points[k - 1], points[mix64(options_.seed, kShuffle, k) % k]);
    SiteTree open(random_sites(region_, n, options_.seed), frame_.wraps());
    std::vector<TorusPoint> owned(points.size());
    std::vector<std::uint32_t> filled(n, 0);
    for (const glm::dvec2& p : points) {
      const std::uint32_t i = open.nearest(p);
      owned[static_cast<std::size_t>(i) * capacity + filled[i]++] = frame_.to(p);
      if (filled[i] == capacity) open.close(i);
    }
    return {capacity, owned};
  }

  /// New space points for the old ones: along a Hilbert curve, the k-th point of a site hands it floor((k+1)
  /// r) - floor(k r) of them, r = new / old capacity.
  CcvtCells refined(CcvtCells& cells, std::uint32_t capacity) const {
    const std::uint64_t old_capacity = cells.capacity();
    std::vector<TorusPoint> old(cells.size() * old_capacity), fresh;
    for (std::size_t k = 0; k < old.size(); ++k) old[k] = {cells.x(0)[k], cells.y(0)[k]};
    for (const glm::dvec2& p :
         spread(region_, cells.size() * static_cast<std::uint64_t>(capacity), options_.seed))
      fresh.push_back(frame_.to(p));
    const std::vector<std::uint32_t> old_order = hilbert_order(old), order = hilbert_order(fresh);
    std::vector<TorusPoint> points(fresh.size());
    std::vector<std::uint32_t> handed(cells.size(), 0), filled(cells.size(), 0);
    std::size_t next = 0;
    for (const std::uint32_t k : old_order) {
      const std::size_t site = k / old_capacity;
      const std::uint64_t until = ++handed[site] * static_cast<std::uint64_t>(capacity) / old_capacity;
      while (filled[site] < until) points[site * capacity + filled[site]++] = fresh[order[next++]];
    }
    return {capacity, points};
  }

  const Region& region_;
  const CcvtOptions& options_;
  Frame frame_;
};

void check(const CcvtOptions& options) {
  if (options.sites == 0) throw InputError("a point set needs at least one point (n >= 1)");
  if (options.capacity == 0) throw InputError("the capacity must be at least 1 space point a site");
  if (static_cast<std::uint64_t>(options.sites) * options.capacity > 1ull << 31) {
    throw InputError(
        fmt::format("{} sites of capacity {} need more than 2^31 space points; lower the capacity",
                    options.sites, options.capacity));
  }
}

}  // namespace

RegionCells region_ccvt_cells(const Region& region, const CcvtOptions& options) {
  check(options);
  if (options.finish) throw InputError("the transport finish has no cells of space points; see region_ccvt");
  RegionOptimiser optimiser(region, options);
  CcvtCells cells = optimiser.run();
  RegionCells result;
  for (const CcvtSite& site : cells.sites) {
    result.sites.push_back(
        optimiser.frame().from(glm::dvec2(site.centre.x, site.centre.y) + glm::dvec2(site.x, site.y)));
  }
  for (std::size_t k = 0; k < cells.size() * cells.capacity(); ++k)
    result.space_points.push_back(optimiser.frame().from({cells.x(0)[k], cells.y(0)[k]}));
  return result;
}

Points region_ccvt(const Region& region, const CcvtOptions& options) {
  if (!options.finish) return region_ccvt_cells(region, options).sites;
  if (region.domain != Domain::kSquare || region.density)
    throw InputError("the transport finish is for even points on the torus or the square");
  constexpr double kSwapShare = 0.1;  // of the time
  CcvtOptions swaps = options;
  swaps.finish = false;
  swaps.capacity = std::min(options.capacity, 64u);
  bool stopped = false;
  if (options.on_progress) swaps.on_progress = [&](double part) { options.on_progress(kSwapShare * part); };
  if (options.stop) swaps.stop = [&] { return stopped = stopped || options.stop(); };
  Points points = region_ccvt(region, swaps);
  if (stopped) return points;
  FinishOptions finish;
  finish.square = true;
  finish.stop = [&](int round, double) {
    if (options.on_progress)
      options.on_progress(kSwapShare + (1 - kSwapShare) * std::min(1.0, round / 150.0));
    return options.stop && options.stop();
  };
  points = transport_finish(points, finish).points;
  if (options.on_progress) options.on_progress(1);
  return points;
}

}  // namespace capcon
