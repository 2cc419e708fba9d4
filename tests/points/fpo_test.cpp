#include "points/fpo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/hash.h"
#include "points/dynamic_voronoi.h"
#include "points/measure.h"

namespace capcon {
namespace {

double area_of(const DynamicVoronoi::Cell& cell) {
  double twice = 0;
  for (std::size_t k = 0; k < cell.size(); ++k) {
    const glm::dvec2 a = cell[k].corner, b = cell[(k + 1) % cell.size()].corner;
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

double reach_of(const std::vector<glm::dvec2>& corners) {
  double reach = 0;
  for (const glm::dvec2& c : corners) reach = std::max(reach, std::hypot(c.x, c.y));
  return reach;
}

/// Cells cut anew by other code, of the sites that are there.
void expect_diagram_of(const DynamicVoronoi& diagram, const std::vector<std::uint32_t>& present,
                       const std::string& where) {
  Points points;
  for (const std::uint32_t i : present) points.push_back(diagram.position(i));
  const std::vector<VoronoiCell> cells = voronoi_cells(points);
  for (std::size_t k = 0; k < present.size(); ++k) {
    std::vector<glm::dvec2> corners;
    for (const auto& edge : diagram.cell(present[k])) corners.push_back(edge.corner);
    ASSERT_NEAR(area_of(diagram.cell(present[k])), cells[k].area, 1e-12) << where << " site " << present[k];
    ASSERT_NEAR(reach_of(corners), reach_of(cells[k].corners), 1e-9) << where << " site " << present[k];
  }
}

Points random_places(std::size_t n, std::uint64_t stream) {
  Points points(n);
  for (std::size_t i = 0; i < n; ++i)
    points[i] = {uniform64(7, stream, 2 * i), uniform64(7, stream, 2 * i + 1)};
  return points;
}

Points grid(int side) {
  Points points;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) points.emplace_back(x / double(side), y / double(side));
  }
  return points;
}

/// On one circle, and its centre: every corner is shared by all.
Points wheel(int spokes) {
  Points points{{0.5, 0.5}};
  for (int k = 0; k < spokes; ++k) {
    points.emplace_back(0.5 + 0.3 * std::cos(2 * M_PI * k / spokes),
                        0.5 + 0.3 * std::sin(2 * M_PI * k / spokes));
  }
  return points;
}

TEST(DynamicVoronoi, StaysTheDiagramOfItsSites) {
  const std::pair<std::string, Points> cases[] = {{"random 1", random_places(1, 1)},
                                                  {"random 2", random_places(2, 2)},
                                                  {"random 3", random_places(3, 3)},
                                                  {"random 5", random_places(5, 4)},
                                                  {"random 12", random_places(12, 5)},
                                                  {"random 60", random_places(60, 6)},
                                                  {"random 400", random_places(400, 7)},
                                                  {"grid 2", grid(2)},
                                                  {"grid 4", grid(4)},
                                                  {"grid 9", grid(9)},
                                                  {"wheel 4", wheel(4)},
                                                  {"wheel 12", wheel(12)},
                                                  {"wheel 50", wheel(50)}};
  for (const auto& [name, places] : cases) {
    const auto n = static_cast<std::uint32_t>(places.size());
    DynamicVoronoi diagram(n);
    std::vector<std::uint32_t> present;
    for (std::uint32_t i = 0; i < n; ++i) {
      diagram.insert(i, places[i], i > 0 ? static_cast<std::uint32_t>(mix64(1, 2, i) % i) : 0);
      present.push_back(i);
    }
    expect_diagram_of(diagram, present, name);
    if (n == 1) continue;
    for (std::uint32_t round = 0; round < 3 * n; ++round) {  // out and back, or elsewhere
      const auto i = static_cast<std::uint32_t>(mix64(3, 4, round) % n);
      const glm::dvec2 old = diagram.position(i);
      std::erase(present, i);
      diagram.remove(i);
      if (n < 70) expect_diagram_of(diagram, present, name + " less one");
      if (round % 3 == 0) {
        diagram.undo_remove();
      } else {
        diagram.insert(i, round % 3 == 1 ? old : random_places(3 * n, 9)[round], present[round % (n - 1)]);
      }
      present.push_back(i);
      if (n < 70) expect_diagram_of(diagram, present, name + " again");
    }
    expect_diagram_of(diagram, present, name + " at last");
  }
}

TEST(Fpo, ReachesThePublishedDistances) {
  // Schloemer, Heck, Deussen 2011: 0.925 and 0.932, means of many sets of 1024 points.
  double least = 0, mean = 0;
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Measures m = measure(fpo({1024, seed}));
    least += m.delta_min / 3;
    mean += m.delta_mean / 3;
    EXPECT_NEAR(m.energy, 1.04, 0.006);
  }
  EXPECT_GT(least, 0.925);
  EXPECT_GT(mean, 0.9315);
  const Measures local = measure(fpo({1024, 1, FpoOptions::Strategy::kLocal}));
  EXPECT_GT(local.delta_min, 0.92);
  EXPECT_GT(local.delta_mean, 0.928);
}

TEST(Fpo, NoPointGainsMuchByMoving) {
  const std::uint32_t n = 200;
  const Points points = fpo({n, 5});
  double nearest = 1;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < i; ++j) {
      glm::dvec2 d = points[i] - points[j];
      nearest = std::min(nearest, std::hypot(d.x - std::round(d.x), d.y - std::round(d.y)));
    }
  }
  double hole = 0;  // the largest empty circle among a million places
  for (int y = 0; y < 1000; ++y) {
    for (int x = 0; x < 1000; ++x) {
      double best = 1;
      for (const glm::dvec2& p : points) {
        const double dx = p.x - (x + 0.5) / 1000, dy = p.y - (y + 0.5) / 1000;
        const double wx = std::abs(dx) > 0.5 ? 1 - std::abs(dx) : dx,
                     wy = std::abs(dy) > 0.5 ? 1 - std::abs(dy) : dy;
        best = std::min(best, wx * wx + wy * wy);
      }
      hole = std::max(hole, std::sqrt(best));
    }
  }
  EXPECT_LT(hole, 1.02 * nearest);
}

TEST(Fpo, NeverShortensTheLeastDistance) {
  for (const Points& start : {grid(5), wheel(9), random_places(50, 20)}) {
    for (const auto strategy : {FpoOptions::Strategy::kGlobal, FpoOptions::Strategy::kLocal}) {
      FpoOptions options;
      options.strategy = strategy;
      const Points points = fpo_from(start, options);
      ASSERT_EQ(points.size(), start.size());
      EXPECT_GE(measure(points).delta_min, measure(start).delta_min - 1e-9);
      EXPECT_GT(measure(points).delta_min, 0.85);
    }
  }
}

// Where points coincide, or all but, no bisector parts them: cells then overlapped, and moves shortened
// distances.
TEST(Fpo, PartsPointsInOnePlace) {
  std::vector<Points> starts{Points(40, {0.25, 0.75}), Points(2, {0, 0}), {{0, 0}, {1 - 0x1p-53, 0x1p-60}}};
  starts.push_back(random_places(30, 21));
  for (int k = 0; k < 30; ++k) starts.back().push_back(starts.back()[k % 5]);
  for (const Points& start : starts) {
    const Points points = fpo_from(start, {});
    ASSERT_EQ(points.size(), start.size());
    for (const glm::dvec2& p : points) EXPECT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
    EXPECT_GT(measure(points).delta_min, 0.85) << start.size();
  }
}

TEST(Fpo, TwoPointsStandFarthestApart) {
  const Points points = fpo({2, 3});
  const glm::dvec2 d = points[1] - points[0];
  EXPECT_NEAR(std::abs(d.x), 0.5, 1e-12);
  EXPECT_NEAR(std::abs(d.y), 0.5, 1e-12);
}

}  // namespace
}  // namespace capcon
