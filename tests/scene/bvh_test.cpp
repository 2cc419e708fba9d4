#include "scene/bvh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <functional>

#include "base/hash.h"
#include "base/parallel.h"

namespace capcon {
namespace {

std::vector<Box> random_boxes(int count, double spread) {
  std::vector<Box> boxes(count);
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 p(uniform64(1, i, 0), uniform64(1, i, 1), uniform64(1, i, 2));
    boxes[i].add(spread * p);
    boxes[i].add(spread * p + 0.02 * glm::dvec3(uniform64(1, i, 3), uniform64(1, i, 4), uniform64(1, i, 5)));
  }
  return boxes;
}

/// What the device takes a word of a node for, in the space of the boxes: the whole word is the centre.
void decode(const Bvh& bvh, std::uint32_t word, int axis, double& low, double& high) {
  const double centre = static_cast<std::int32_t>(word) / 65536.0 + 32768;
  const double half = word & 0xffffu;
  low = (centre - half) / bvh.grid_scale[axis] + bvh.grid_origin[axis];
  high = (centre + half) / bvh.grid_scale[axis] + bvh.grid_origin[axis];
}

/// Walks the whole tree: every primitive is in one leaf, within every box above it; returns the deepest
/// stack.
void check_tree(const std::vector<Box>& boxes) {
  const Bvh bvh = build_bvh(boxes);
  ASSERT_EQ(bvh.order.size(), boxes.size());
  std::vector<int> seen(boxes.size(), 0);
  std::uint32_t deepest = 0;
  const std::function<Box(std::uint32_t, std::uint32_t)> walk = [&](std::uint32_t node,
                                                                    std::uint32_t waiting) {
    const glm::uvec4 links = bvh.texels[4 * node + 3];
    Box all;
    std::uint32_t inner = 0;
    for (int c = 0; c < 4; ++c) inner += links.x >> c & 1u;
    const std::uint32_t below = waiting + (inner > 1 ? 1 : 0);
    deepest = std::max(deepest, below);
    for (int c = 0; c < 4; ++c) {
      Box content;
      const std::uint32_t mask = c < 2 ? links.z >> (16 * c) & 0xffffu : links.w >> (16 * (c - 2)) & 0xffffu;
      const bool is_inner = (links.x >> c & 1u) != 0;
      EXPECT_FALSE(is_inner && mask != 0);
      if (is_inner) content = walk((links.x >> 4) + c, below);
      for (int bit = 0; bit < 16; ++bit) {
        if ((mask >> bit & 1u) == 0) continue;
        const std::uint32_t primitive = bvh.order[links.y + bit];
        ++seen[primitive];
        content.add(boxes[primitive]);
      }
      for (int axis = 0; axis < 3; ++axis) {
        if (!is_inner && mask == 0) continue;
        double low = 0, high = 0;
        decode(bvh, bvh.texels[4 * node + axis][c], axis, low, high);
        const double cell = 1 / bvh.grid_scale[axis];
        EXPECT_LE(low, content.low[axis] - 0.2 * cell) << "the device's rounding is not allowed for";
        EXPECT_GE(high, content.high[axis] + 0.2 * cell);
        if (!is_inner) {
          const double room =
              4.1 * cell + 1.3e-7 * (std::abs(content.low[axis]) + std::abs(content.high[axis]));
          EXPECT_GE(low, content.low[axis] - room) << "a box far larger than what it holds";
          EXPECT_LE(high, content.high[axis] + room);
        }
      }
      if (is_inner || mask != 0) all.add(content);
    }
    return all;
  };
  walk(0, 0);
  EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int s) { return s == 1; }));
  EXPECT_EQ(bvh.stack_entries, std::max(deepest, 1u));
}

TEST(Bvh, HoldsEveryPrimitiveOnceInsideItsBoxes) {
  for (int count : {1, 2, 3, 4, 5, 17, 1000}) check_tree(random_boxes(count, 1));
}

TEST(Bvh, SurvivesCoincidentFlatAndFarAwayBoxes) {
  check_tree(std::vector<Box>(100, random_boxes(1, 1)[0]));  // all the same
  std::vector<Box> flat = random_boxes(200, 1);
  for (Box& box : flat) box.low.y = box.high.y = 3;
  check_tree(flat);
  std::vector<Box> far = random_boxes(200, 1);
  for (Box& box : far) {
    box.low += glm::dvec3(1e6);
    box.high += glm::dvec3(1e6);
  }
  check_tree(far);
  check_tree({Box{glm::dvec3(1), glm::dvec3(1)}});  // one point
  std::vector<Box> mixed = random_boxes(300, 1);
  mixed[7].high = glm::dvec3(1e5);  // one huge among tiny
  check_tree(mixed);
}

// Each in a box of its own, so that a ray meets only those whose own box it meets.
TEST(Bvh, CostlyPrimitivesGetLeavesOfTheirOwn) {
  const auto boxes = random_boxes(2000, 1);
  const auto shared = [&](double cost) {
    const BinaryTree tree = build_binary_tree(boxes, {}, cost);
    std::size_t all = 0;
    for (const BinaryNode& node : tree.nodes) all += node.count > 1 ? node.count : 0;
    return all;
  };
  EXPECT_GT(shared(1), 1000u);
  EXPECT_LT(shared(20), 100u);
}

TEST(Bvh, IsTheSameForAnyNumberOfThreads) {
  // Many small ones side by side, as those of objects are, so that threads wait where they may; and one so
  // large that all threads share in a node.
  for (const auto& [count, builds] : {std::pair(40000, 200), std::pair(300000, 1)}) {
    const auto boxes = random_boxes(count, 1);
    ::setenv("CAPCON_THREADS", "1", 1);
    const Bvh one = build_bvh(boxes);
    ::setenv("CAPCON_THREADS", "8", 1);
    std::atomic<int> different = 0;
    parallel_for(builds, [&](std::size_t) {
      const BinaryTree tree = build_binary_tree(boxes);
      for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
        if (tree.nodes[n].count == 0 && tree.nodes[n].first <= n) {  // a walk would not end
          ++different;
          return;
        }
      }
      const Bvh eight = collapse(tree);
      if (one.order != eight.order || one.texels != eight.texels) ++different;
    });
    ::unsetenv("CAPCON_THREADS");
    EXPECT_EQ(different, 0) << count;
  }
}

/// Small triangles and, every thirtieth, one through the whole cube, as texels, and their boxes.
std::vector<glm::uvec4> mixed_triangles(int count, std::vector<Box>& boxes) {
  std::vector<glm::uvec4> texels;
  boxes.resize(count);
  for (int i = 0; i < count; ++i) {
    const auto random = [&](int k) { return uniform64(2, i, k); };
    const glm::dvec3 from(random(0), random(1), random(2));
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 corner(random(3 * k + 3), random(3 * k + 4), random(3 * k + 5));
      const glm::vec3 p(i % 30 == 0 ? corner : from + 0.01 * corner);
      boxes[i].add(glm::dvec3(p));
      texels.emplace_back(std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y),
                          std::bit_cast<std::uint32_t>(p.z), i);
    }
  }
  return texels;
}

/// Whether a point of a primitive lies within a leaf that names it and within all boxes above.
bool finds(const Bvh& bvh, std::uint32_t node, glm::dvec3 p, std::uint32_t primitive) {
  const glm::uvec4 links = bvh.texels[4 * node + 3];
  for (int c = 0; c < 4; ++c) {
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis) {
      double low = 0, high = 0;
      decode(bvh, bvh.texels[4 * node + axis][c], axis, low, high);
      inside = inside && p[axis] >= low && p[axis] <= high;
    }
    if (!inside) continue;
    if ((links.x >> c & 1u) != 0 && finds(bvh, (links.x >> 4) + c, p, primitive)) return true;
    const std::uint32_t mask = c < 2 ? links.z >> (16 * c) & 0xffffu : links.w >> (16 * (c - 2)) & 0xffffu;
    for (int bit = 0; bit < 16; ++bit) {
      if ((mask >> bit & 1u) != 0 && bvh.order[links.y + bit] == primitive) return true;
    }
  }
  return false;
}

double expected_cost(const BinaryTree& tree) {
  double cost = 0;
  for (const BinaryNode& node : tree.nodes)
    cost += node.box.half_area() * (node.count > 0 ? node.count : 1.0);
  return cost / tree.nodes[0].box.half_area();
}

TEST(Bvh, SpatialSplitsLoseNoPointOfATriangle) {
  std::vector<Box> boxes;
  const auto texels = mixed_triangles(3000, boxes);
  const BinaryTree split = build_binary_tree(boxes, texels), whole = build_binary_tree(boxes);
  EXPECT_GT(split.order.size(), boxes.size() + 100) << "nothing was cut";
  EXPECT_LE(split.order.size(), 1.3 * boxes.size());
  EXPECT_LT(expected_cost(split), 0.9 * expected_cost(whole));
  const Bvh bvh = collapse(split);
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    glm::dvec3 corner[3];
    for (int k = 0; k < 3; ++k) {
      const glm::uvec4 t = texels[3 * i + k];
      corner[k] = {std::bit_cast<float>(t.x), std::bit_cast<float>(t.y), std::bit_cast<float>(t.z)};
    }
    for (int j = 0; j < 20; ++j) {
      double u = j < 3 ? j == 1 : uniform64(3, i, 2 * j), v = j < 3 ? j == 2 : uniform64(3, i, 2 * j + 1);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const glm::dvec3 p = corner[0] + u * (corner[1] - corner[0]) + v * (corner[2] - corner[0]);
      ASSERT_TRUE(finds(bvh, 0, p, i)) << i << ' ' << j;
    }
  }
}

TEST(Bvh, SpatialSplitsAreTheSameForAnyNumberOfThreads) {
  std::vector<Box> boxes;
  const auto texels = mixed_triangles(40000, boxes);
  ::setenv("CAPCON_THREADS", "1", 1);
  const Bvh one = collapse(build_binary_tree(boxes, texels));
  ::setenv("CAPCON_THREADS", "4", 1);
  const Bvh four = collapse(build_binary_tree(boxes, texels));
  ::unsetenv("CAPCON_THREADS");
  EXPECT_EQ(one.order, four.order);
  EXPECT_EQ(one.texels, four.texels);
}

}  // namespace
}  // namespace capcon
