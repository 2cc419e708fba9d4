#include "points/ccvt.h"

#include <fmt/format.h>

#include <glm/common.hpp>

#include "base/error.h"
#include "points/ccvt_optimise.h"
#include "points/ccvt_start.h"
#include "points/measure.h"

namespace capcon {

namespace {

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

}  // namespace

CcvtResult ccvt(const CcvtOptions& options) {
  check(options);
  // A coarse capacity is but a start for the next: few exchanges a site are near enough to its end.
  std::vector<std::uint32_t> capacities{options.capacity};
  while (capacities.back() > 16) capacities.push_back(capacities.back() / 4);
  CcvtResult result;
  CcvtState state = random_cells(options.sites, capacities.back(), options.seed);
  const auto run = [&](std::uint64_t enough, const std::function<void(std::uint64_t)>& on_pass) {
    const CcvtEffort effort = optimise(state.cells, enough, on_pass);
    result.passes += effort.passes;
    result.swaps += effort.swaps;
  };
  for (; capacities.size() > 1; capacities.pop_back()) {
    run(1 + state.cells.size() * state.cells.capacity() / 64, {});
    state = refined_cells(state, capacities[capacities.size() - 2], options.seed);
  }
  const auto report = [&](std::uint64_t swaps) {
    options.on_pass(state.cells.energy() / kHexagonEnergy, swaps);
  };
  run(1, options.on_pass ? std::function<void(std::uint64_t)>(report) : nullptr);
  result.energy = state.cells.energy() / kHexagonEnergy;
  for (const CcvtSite& site : state.cells.sites) result.points.push_back(place_of(site));
  return result;
}

}  // namespace capcon
