// The suite's own tools: a leak is seen where there is a hole, and a mesh said to be closed is.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <map>

#include "base/error.h"
#include "stability/closed_mesh.h"
#include "stability/suite.h"

namespace capcon::stability {
namespace {

TEST(ClosedMesh, HasEveryEdgeOnceInEachDirection) {
  const TriangleMesh mesh = closed_mesh(3, 1);
  EXPECT_EQ(mesh.triangles.size(), 20u * 64);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const glm::uvec3& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    ASSERT_TRUE(edges.count({edge.second, edge.first}));
  }
}

TEST(ClosedMesh, HoldsABall) {
  for (const glm::vec3& p : closed_mesh(3, 1).positions) ASSERT_GT(glm::dot(p, p), 0.5f * 0.5f);
}

TEST(Suite, NamesAreUniqueAndKnown) {
  SuiteOptions options;
  std::map<std::string, int> names;
  for (const auto& [group, name] : names_of_checks(options)) ++names[name];
  EXPECT_GT(names.size(), 75u);
  for (const auto& [name, count] : names) EXPECT_EQ(count, 1) << name;
  options.brief = true;
  EXPECT_GT(names_of_checks(options).size(), 10u);
  EXPECT_LT(names_of_checks(options).size(), 25u);
  options.only = {"no-such-check"};
  EXPECT_THROW(names_of_checks(options), InputError);
}

}  // namespace
}  // namespace capcon::stability
