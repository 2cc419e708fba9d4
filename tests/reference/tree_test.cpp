// The tree and the double-precision primitives against a brute force over everything in long double, written
// another way: Moeller-Trumbore for triangles, the plain quadratic and planes for spheres and disks.
#include "reference/tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <random>

#include "reference/scenes.h"

namespace capcon {
namespace {

using reference::Primitives;
using reference::Ray;
using reference::Tree;
using Real = long double;
using V = glm::vec<3, Real>;
using M = glm::mat<4, 4, Real>;

/// Nearest hit and how far the decision was from an edge; a case within rounding error of an edge decides
/// nothing.
struct Answer {
  Real t = std::numeric_limits<Real>::infinity();
  bool close_call = false;
};

void offer(Answer& answer, Real t, bool inside, Real margin) {
  if (std::abs(margin) < 1e-9L || std::abs(t) < 1e-9L) answer.close_call = true;
  if (inside && t > 0) answer.t = std::min(answer.t, t);
}

void brute_triangle(Answer& answer, const V& a, const V& b, const V& c, const V& o, const V& d) {
  const V e1 = b - a, e2 = c - a, p = glm::cross(d, e2), s = o - a, q = glm::cross(s, e1);
  const Real det = glm::dot(e1, p);
  if (det == 0) return;
  const Real u = glm::dot(s, p) / det, v = glm::dot(d, q) / det;
  const Real margin = std::min({u, v, 1 - u - v});
  offer(answer, glm::dot(e2, q) / det, margin >= 0, margin);
}

void brute_round(Answer& answer, const Shape& shape, const M& to_world, const V& o, const V& d) {
  const M inverse = glm::inverse(to_world);
  const V lo(inverse * glm::vec<4, Real>(o, 1)), ld(inverse * glm::vec<4, Real>(d, 0));
  if (shape.kind == ShapeKind::disk) {
    const Real t = (shape.height - lo.z) / ld.z;
    const Real r = std::hypot(lo.x + t * ld.x, lo.y + t * ld.y);
    const Real margin = std::min(r - shape.inner_radius, shape.radius - r);
    offer(answer, t, margin >= 0, margin);
    return;
  }
  const Real a = glm::dot(ld, ld), b = 2 * glm::dot(lo, ld),
             c = glm::dot(lo, lo) - Real(shape.radius) * shape.radius;
  const Real disc = b * b - 4 * a * c;
  for (const int sign : {-1, 1}) {
    offer(answer, (-b + sign * std::sqrt(std::max<Real>(0, disc))) / (2 * a), disc >= 0, disc);
  }
}

Answer brute_force(const Scene& scene, const Ray& ray) {
  Answer answer;
  const V o(ray.origin), d(ray.direction);
  const auto shape_at = [&](const Shape& shape, const glm::dmat4& to_world) {
    if (shape.kind != ShapeKind::mesh) return brute_round(answer, shape, M(to_world), o, d);
    const TriangleMesh& mesh = scene.meshes[shape.mesh];
    const auto vertex = [&](unsigned i) {
      return V(glm::vec3(glm::dvec3(to_world * glm::dvec4(glm::dvec3(mesh.positions[i]), 1))));
    };
    for (const glm::uvec3& t : mesh.triangles) {
      brute_triangle(answer, vertex(t.x), vertex(t.y), vertex(t.z), o, d);
    }
  };
  for (const Shape& shape : scene.shapes) shape_at(shape, shape.to_world);
  for (const Instance& instance : scene.instances) {
    for (const Shape& shape : scene.objects[instance.object].shapes)
      shape_at(shape, instance.to_world * shape.to_world);
  }
  return answer;
}

class Random {
 public:
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  glm::dvec3 point(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  glm::dmat4 placement(double size, double shrink) {
    glm::dmat4 m = glm::translate(glm::dmat4(1), point(size));
    m = glm::rotate(m, number(0, 6), glm::normalize(point(1)));
    return glm::scale(m, shrink * glm::dvec3(number(0.3, 1), -number(0.3, 1), number(0.3, 1)));
  }

 private:
  std::mt19937 engine_{12345};
};

/// Triangles of all sizes, ellipsoids and rings, half of them in instances of an object.
Scene soup(Random& random) {
  test::Builder b;
  const auto mesh = [&](int triangles) {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> indices;
    for (int i = 0; i < triangles; ++i) {
      const glm::dvec3 centre = random.point(3);
      const double size = std::pow(10.0, random.number(-1.5, 0.5));
      for (int k = 0; k < 3; ++k) positions.emplace_back(centre + random.point(size));
      indices.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    b.mesh(positions, indices, random.placement(1, 1));
  };
  mesh(120);
  for (int i = 0; i < 5; ++i) b.sphere(random.number(0.1, 0.6), random.placement(3, 1));
  for (int i = 0; i < 5; ++i) b.disk(1, random.number(-1, 1), random.number(0, 0.8), random.placement(3, 1));
  b.scene.objects.push_back({"object", b.scene.shapes});
  b.scene.instances = {{0, random.placement(4, 0.5)}, {0, random.placement(4, 0.3)}};
  b.scene.shapes.clear();
  mesh(200);
  for (int i = 0; i < 5; ++i) b.sphere(random.number(0.1, 0.6), random.placement(3, 1));
  for (int i = 0; i < 5; ++i) b.disk(1, random.number(-1, 1), 0, random.placement(3, 1));
  return b.scene;
}

TEST(Tree, AgreesWithBruteForce) {
  Random random;
  int hits = 0, close_calls = 0;
  constexpr int kSoups = 6, kRays = 400;
  for (int s = 0; s < kSoups; ++s) {
    const Scene scene = soup(random);
    const Primitives primitives(scene);
    ASSERT_EQ(primitives.size(), 200u + 10 + 2 * (120 + 10));
    const Tree tree(primitives);
    for (int i = 0; i < kRays; ++i) {
      const glm::dvec3 origin = random.point(6);
      Ray ray(origin, glm::normalize(random.point(2) - origin));
      if (i % 7 == 0)
        ray = {random.point(2), glm::dvec3(i % 3 == 0, i % 3 == 1, i % 3 == 2)};  // along an axis
      const Answer expected = brute_force(scene, ray);
      if (expected.close_call) {
        ++close_calls;
        continue;
      }
      const auto hit = tree.closest(ray);
      ASSERT_EQ(hit.has_value(), std::isfinite(expected.t)) << "soup " << s << " ray " << i;
      if (!hit) {
        EXPECT_FALSE(tree.occluded(ray, 1e300));
        continue;
      }
      ++hits;
      const double t = double(expected.t);
      ASSERT_NEAR(hit->t, t, 1e-9 * t);
      EXPECT_TRUE(tree.occluded(ray, t * 1.000001));
      EXPECT_FALSE(tree.occluded(ray, t * 0.999999));
      const reference::SurfacePoint at = primitives.surface(hit->primitive, ray, hit->t);
      EXPECT_LT(glm::length(at.position - (ray.origin + hit->t * ray.direction)), 1e-9);
      EXPECT_NEAR(glm::length(at.normal), 1, 1e-12);
    }
  }
  EXPECT_GT(hits, kSoups * kRays / 4);
  EXPECT_LT(close_calls, kSoups * kRays / 50);
}

TEST(Tree, NoRaySlipsThroughEdgesAndVertices) {
  // A finely folded height field; rays aimed at points of its edges and at its vertices must hit.
  Random random;
  constexpr int kSide = 12;
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
  for (int z = 0; z <= kSide; ++z) {
    for (int x = 0; x <= kSide; ++x) positions.emplace_back(x, random.number(0, 0.7), z);
  }
  for (unsigned z = 0; z < kSide; ++z) {
    for (unsigned x = 0; x < kSide; ++x) {
      const unsigned i = z * (kSide + 1) + x;
      triangles.emplace_back(i, i + 1, i + kSide + 2);
      triangles.emplace_back(i, i + kSide + 2, i + kSide + 1);
    }
  }
  test::Builder b;
  b.mesh(positions, triangles);
  const Primitives primitives(b.scene);
  const Tree tree(primitives);
  for (int i = 0; i < 100000; ++i) {
    const unsigned x = 1 + unsigned(random.number(0, kSide - 2)),
                   z = 1 + unsigned(random.number(0, kSide - 2));
    const unsigned from = z * (kSide + 1) + x;
    const unsigned steps[] = {0, 1, kSide + 1, kSide + 2};
    const glm::dvec3 p(positions[from]), q(positions[from + steps[i % 4]]);
    const glm::dvec3 target = glm::mix(p, q, random.number(0, 1));
    const double far = std::pow(10, random.number(0, 3));
    const glm::dvec3 origin =
        target + far * glm::dvec3(random.number(-0.4, 0.4), 1, random.number(-0.4, 0.4));
    ASSERT_TRUE(tree.closest({origin, glm::normalize(target - origin)}).has_value()) << i;
  }
}

TEST(Tree, OneIgnoredPrimitiveAndRangeLimits) {
  test::Builder b;
  b.mesh({{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}}, {{0, 1, 2}});
  const Primitives primitives(b.scene);
  const Tree tree(primitives);
  const Ray down{{0, 2, 0}, {0, -1, 0}};
  EXPECT_TRUE(tree.occluded(down, 2));  // the end of the range belongs to it
  EXPECT_FALSE(tree.occluded(down, 1.9999999999));
  EXPECT_FALSE(tree.occluded(down, 10, {0}));
  EXPECT_FALSE(tree.occluded(down, 10, {reference::Ignored::kNone, 0, 1}));
  EXPECT_TRUE(tree.occluded(down, 10, {reference::Ignored::kNone, 1, 7}));
  EXPECT_TRUE(tree.closest(down).has_value());
  EXPECT_FALSE(tree.closest(down, {0}).has_value());
  EXPECT_FALSE(tree.occluded({{0, 0, 0}, {0, -1, 0}}, 10));  // its beginning does not
  EXPECT_EQ(tree.scale(), 1);
}

TEST(Tree, ManyEqualPrimitivesAndNone) {
  test::Builder b;
  const std::vector<glm::uvec3> same(1000, glm::uvec3(0, 1, 2));
  b.mesh({{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}}, same);
  const Primitives primitives(b.scene);
  const Tree tree(primitives);
  const auto hit = tree.closest({{0, 2, 0}, {0, -1, 0}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->primitive, 0u);
  const Scene nothing;
  const Primitives none(nothing);
  EXPECT_FALSE(Tree(none).closest({{0, 2, 0}, {0, -1, 0}}));
}

TEST(Tree, DegenerateTrianglesAreNeverHit) {
  test::Builder b;
  b.mesh({{-1, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {{0, 1, 2}, {0, 0, 0}, {0, 1, 1}});
  b.sphere(1, glm::dmat4(0));
  const Primitives primitives(b.scene);
  EXPECT_FALSE(Tree(primitives).closest({{0, 2, 0}, {0, -1, 0}}));
}

}  // namespace
}  // namespace capcon
