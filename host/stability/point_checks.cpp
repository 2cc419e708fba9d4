#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>

#include "points/region_ccvt.h"
#include "stability/checks.h"

namespace capcon::stability {
namespace {

constexpr int kSide = 32;  // texels of a density

/// What of a set of cells breaks a promise; looked at from outside, after the swaps have ended.
struct Broken {
  std::uint64_t non_finite = 0, misplaced = 0, off_centre = 0, gains = 0;
  std::uint64_t all() const { return non_finite + misplaced + off_centre + gains; }
};

double squared(const glm::dvec2& a, const glm::dvec2& b) {
  return glm::dot(a - b, a - b);
}

/// The square: nothing wraps. Sites stand at the centroids of their K space points, which are in texels with
/// mass, and no exchange of two space points would lower the energy by more than rounding.
Broken look(const RegionCells& cells, std::uint32_t capacity, const Density* density) {
  Broken broken;
  const std::size_t n = cells.sites.size();
  std::vector<glm::dvec2> centre(n, glm::dvec2(0));
  for (std::size_t k = 0; k < cells.space_points.size(); ++k) {
    const glm::dvec2 p = cells.space_points[k];
    if (!std::isfinite(p.x + p.y)) ++broken.non_finite;
    const bool inside = p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1;
    const auto texel = [](double v, std::size_t count) {
      return std::min(count - 1, static_cast<std::size_t>(std::max(0.0, v) * static_cast<double>(count)));
    };
    if (!inside || (density && density->at(texel(p.x, density->width()), texel(p.y, density->height())) == 0))
      ++broken.misplaced;
    centre[k / capacity] += p / static_cast<double>(capacity);
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (!(squared(centre[i], cells.sites[i]) < 1e-12)) ++broken.off_centre;
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      // The best exchange of the pair: each gives what gains most.
      double first = -1, second = -1;
      for (std::uint32_t k = 0; k < capacity; ++k) {
        const glm::dvec2 a = cells.space_points[i * capacity + k], b = cells.space_points[j * capacity + k];
        first = std::max(first, squared(a, cells.sites[i]) - squared(a, cells.sites[j]));
        second = std::max(second, squared(b, cells.sites[j]) - squared(b, cells.sites[i]));
      }
      if (first + second > 1e-6 * squared(cells.sites[i], cells.sites[j]) + 1e-12) ++broken.gains;
    }
  }
  return broken;
}

struct Densities {
  std::string name, what;
  std::function<double(int column, int row)> value;  ///< empty: none
};

Check run(const Densities& densities) {
  const auto start = std::chrono::steady_clock::now();
  Check check;
  check.group = "points";
  check.name = densities.name;
  check.what = densities.what + "; n = 1, 2, 3, 31, 127, capacities 1, 2, 64, three seeds";
  check.bound =
      "every cell its capacity, in places with mass, site at the centroid, no exchange left that gains";
  check.reason =
      "what an optimum of swaps is, looked at from outside; the bench of invariants looks at every swap";
  Region region{Domain::kSquare, nullptr};
  if (densities.value) {
    std::vector<double> values;
    for (int i = 0; i < kSide * kSide; ++i) values.push_back(densities.value(i % kSide, i / kSide));
    region.density = std::make_shared<Density>(kSide, kSide, std::move(values));
  }
  Broken all;
  for (const std::uint32_t n : {1u, 2u, 3u, 31u, 127u}) {
    for (const std::uint32_t capacity : {1u, 2u, 64u}) {
      for (const std::uint64_t seed : {1u, 2u, 3u}) {
        CcvtOptions options;
        options.sites = n;
        options.capacity = capacity;
        options.seed = seed;
        const RegionCells cells = region_ccvt_cells(region, options);
        ++check.values;
        if (cells.sites.size() != n || cells.space_points.size() != std::size_t(n) * capacity) {
          ++check.beyond;
          continue;
        }
        const Broken broken = look(cells, capacity, region.density.get());
        check.non_finite += broken.non_finite > 0;
        check.beyond += broken.all() > 0;
        all.misplaced += broken.misplaced;
        all.off_centre += broken.off_centre;
        all.gains += broken.gains;
      }
    }
  }
  check.measured = fmt::format("{} space points without mass, {} sites off, {} pairs that would gain",
                               all.misplaced, all.off_centre, all.gains);
  check.passed = check.beyond == 0;
  check.command = "capcon points ccvt -n 127 --capacity 64 --domain square --density FILE";
  check.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return check;
}

}  // namespace

std::vector<Task> point_tasks() {
  const std::vector<Densities> all = {
      {"points-even", "no density", {}},
      {"points-contrast-1e12", "a density from 1e-12 to 1",
       [](int column, int) { return std::pow(10.0, -12 + 12.0 * column / (kSide - 1)); }},
      {"points-one-texel", "all mass in one texel",
       [](int column, int row) { return column == 5 && row == 9 ? 1.0 : 0.0; }},
      {"points-half", "an empty half", [](int column, int) { return column < kSide / 2 ? 1.0 : 0.0; }},
      {"points-line", "all mass in a row of texels", [](int, int row) { return row == 7 ? 1.0 : 0.0; }},
      {"points-board", "a chessboard", [](int column, int row) { return (column + row) % 2 ? 1.0 : 0.0; }},
      {"points-1e300", "densities of 1e300 and 1e-300",
       [](int column, int row) { return (column + row) % 3 ? 1e300 : 1e-300; }}};
  std::vector<Task> tasks;
  for (const Densities& d : all) tasks.push_back({"points", d.name, [=] { return run(d); }});
  return tasks;
}

}  // namespace capcon::stability
