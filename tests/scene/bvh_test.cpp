#include "scene/bvh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "base/hash.h"

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

/// Walks the whole tree: every primitive is in one leaf, within every box above it; returns the deepest stack.
void check_tree(const std::vector<Box>& boxes) {
  const Bvh bvh = build_bvh(boxes);
  ASSERT_EQ(bvh.order.size(), boxes.size());
  std::vector<int> seen(boxes.size(), 0);
  std::uint32_t deepest = 0;
  const std::function<Box(std::uint32_t, std::uint32_t)> walk = [&](std::uint32_t node, std::uint32_t waiting) {
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
        const std::uint32_t planes = bvh.texels[4 * node + axis][c];
        const double low = (planes & 0xffffu) / bvh.grid_scale[axis] + bvh.grid_origin[axis];
        const double high = (planes >> 16) / bvh.grid_scale[axis] + bvh.grid_origin[axis];
        if (!is_inner && mask == 0) {
          EXPECT_GT(planes & 0xffffu, planes >> 16) << "an absent child is open";
        } else {
          EXPECT_LE(low, content.low[axis]);
          EXPECT_GE(high, content.high[axis]);
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

TEST(Bvh, IsTheSameForAnyNumberOfThreads) {
  const auto boxes = random_boxes(60000, 1);
  ::setenv("CAPCON_THREADS", "1", 1);
  const Bvh one = build_bvh(boxes);
  ::setenv("CAPCON_THREADS", "4", 1);
  const Bvh four = build_bvh(boxes);
  ::unsetenv("CAPCON_THREADS");
  EXPECT_EQ(one.order, four.order);
  EXPECT_EQ(one.texels, four.texels);
}

}  // namespace
}  // namespace capcon
