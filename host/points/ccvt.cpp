#include "points/ccvt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numeric>
#include <utility>

#include "base/error.h"
#include "points/ccvt_optimise.h"
#include "points/ccvt_start.h"
#include "points/measure.h"
#include "points/transport_finish.h"

namespace capcon {

namespace {

constexpr std::uint32_t kBeforeFinish = 64;  // capacity from which the finish starts best
constexpr double kSwapShare = 0.2;           // of the time, when there is a finish

void check(const CcvtOptions& options) {
  if (options.sites == 0) throw InputError("a point set needs at least one point (n >= 1)");
  if (options.capacity == 0) throw InputError("the capacity must be at least 1 space point a site");
  const std::uint64_t space_points = static_cast<std::uint64_t>(options.sites) * options.capacity;
  if (space_points > 1ull << 31) {
    throw InputError(
        fmt::format("{} sites of capacity {} are {} space points, more than 2^31; lower the capacity",
                    options.sites, options.capacity, space_points));
  }
}

glm::dvec2 place_of(const CcvtSite& site) {
  glm::dvec2 p = (glm::dvec2(site.centre.x, site.centre.y) + glm::dvec2(site.x, site.y)) * 0x1p-32;
  p -= glm::floor(p);
  return {p.x < 1 ? p.x : 0, p.y < 1 ? p.y : 0};  // a tiny negative coordinate rounds up to 1
}

/// The capacities that are gone through, each a start for the next.
std::vector<std::uint32_t> capacities_up_to(std::uint32_t capacity) {
  std::vector<std::uint32_t> list{capacity};
  while (list.front() > 16) list.insert(list.begin(), list.front() / 4);
  return list;
}

/// How much seems done: the passes at one capacity end when the exchanges, which fall about geometrically,
/// are gone.
class Estimate {
 public:
  Estimate(const std::vector<std::uint32_t>& capacities, const CcvtOptions& options)
      : options_(options), total_(std::accumulate(capacities.begin(), capacities.end(), 0.0)) {}
  void next_capacity(std::uint32_t capacity) {
    before_ += share_;
    share_ = capacity / total_;
    first_ = 0;
    inner_ = 0;
  }
  void pass(std::uint64_t swaps) {
    const double left = std::log2(1.0 + static_cast<double>(swaps));
    if (first_ == 0) first_ = left;
    if (first_ > 0) inner_ = std::max(inner_, 1 - left / first_);
    if (options_.on_progress)
      options_.on_progress((options_.finish ? kSwapShare : 1) * (before_ + share_ * inner_));
  }

 private:
  const CcvtOptions& options_;
  double total_, before_ = 0, share_ = 0, first_ = 0, inner_ = 0;
};

}  // namespace

CcvtResult ccvt(const CcvtOptions& options) {
  check(options);
  const std::vector<std::uint32_t> capacities =
      capacities_up_to(options.finish ? std::min(options.capacity, kBeforeFinish) : options.capacity);
  Estimate estimate(capacities, options);
  CcvtResult result;
  CcvtState state = random_cells(options.sites, capacities.front(), options.seed);
  for (const std::uint32_t capacity : capacities) {
    const bool last = capacity == capacities.back();
    if (capacity != capacities.front()) state = refined_cells(state, capacity, options.seed);
    estimate.next_capacity(capacity);
    const CcvtEffort effort = optimise(
        state.cells, last ? CcvtPace{} : coarse_pace(state.cells.size(), capacity),
        [&](std::uint64_t swaps) {
          if (last && options.on_pass) options.on_pass(state.cells.energy() / kHexagonEnergy, swaps);
          estimate.pass(swaps);
        },
        options.stop);
    result.passes += effort.passes;
    result.swaps += effort.swaps;
    result.capacity = capacity;
    result.stopped = effort.stopped || (!last && options.stop && options.stop());
    if (result.stopped) break;
  }
  result.energy = state.cells.energy() / kHexagonEnergy;
  for (const CcvtSite& site : state.cells.sites) result.points.push_back(place_of(site));
  if (options.finish && !result.stopped) {
    FinishOptions finish;
    finish.stop = [&](int round, double) {
      if (options.on_progress)
        options.on_progress(kSwapShare + (1 - kSwapShare) * std::min(1.0, round / 150.0));
      return options.stop && options.stop();
    };
    FinishResult finished = transport_finish(result.points, finish);
    result.points = std::move(finished.points);
    result.energy = finished.energy;
    result.stopped = finished.stopped;
    result.rounds = finished.rounds;
    if (options.on_progress) options.on_progress(1);
  }
  return result;
}

}  // namespace capcon
