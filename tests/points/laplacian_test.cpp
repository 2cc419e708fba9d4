#include "points/laplacian.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "points/descent.h"

namespace capcon {
namespace {

/// The torus grid of side x side nodes, weights `across` and `up`.
Laplacian grid(std::uint32_t side, double across, double up) {
  Laplacian matrix;
  for (std::uint32_t y = 0; y < side; ++y) {
    for (std::uint32_t x = 0; x < side; ++x) {
      matrix.add(y * side + (x + 1) % side, across);
      matrix.add(y * side + (x + side - 1) % side, across);
      matrix.add((y + 1) % side * side + x, up);
      matrix.add((y + side - 1) % side * side + x, up);
      matrix.end_row();
    }
  }
  return matrix;
}

/// Waves are eigenvectors: L cos = 4 (across sin^2(pi kx / side) + up sin^2(pi ky / side)) cos.
TEST(LaplacianSolver, SolvesForWavesInAFewStepsOfAnySize) {
  for (const std::uint32_t side : {4u, 16u, 64u, 256u}) {
    for (const auto& [kx, ky] : {std::pair(1, 0), std::pair(1, 1), std::pair(2, 1)}) {
      std::vector<double> wave, v;
      for (std::uint32_t i = 0; i < side * side; ++i)
        wave.push_back(std::cos(2 * M_PI * (kx * double(i % side) + ky * double(i / side)) / side));
      LaplacianSolver solver;
      solver.set(grid(side, 1, 0.7));
      std::vector<double> right = wave;
      for (double& b : right) b += 3;  // the mean is taken off
      const int steps = solver.solve(right, 1e-8, 200, v);
      EXPECT_LT(steps, 25) << side;
      const auto sine2 = [&](int k) { return std::pow(std::sin(M_PI * k / side), 2); };
      const double eigenvalue = 4 * (sine2(kx) + 0.7 * sine2(ky));
      double worst = 0;
      for (std::size_t i = 0; i < v.size(); ++i)
        worst = std::max(worst, std::abs(v[i] * eigenvalue - wave[i]));
      EXPECT_LT(worst, 1e-5) << side << " " << kx << " " << ky;
    }
  }
}

/// Of a quadratic function limited-memory BFGS with exact memory finds the place where the gradient is 0.
TEST(DescentMemory, FindsTheLeastOfAQuadraticFunction) {
  const std::vector<glm::dvec2> slopes{{1, 2}, {4, 0.5}, {3, 8}};
  std::vector<glm::dvec2> x{{5, -3}, {1, 1}, {-2, 7}};
  DescentMemory memory(8);
  const auto gradient = [&] {
    std::vector<glm::dvec2> g(3);
    for (int i = 0; i < 3; ++i) g[i] = slopes[i] * x[i];
    return g;
  };
  for (int step = 0; step < 60; ++step) {
    const std::vector<glm::dvec2> before = gradient();
    const std::vector<glm::dvec2> move = memory.step_from(before, 0.1);
    for (int i = 0; i < 3; ++i) x[i] += move[i];
    std::vector<glm::dvec2> change = gradient();
    for (int i = 0; i < 3; ++i) change[i] -= before[i];
    memory.learn(move, change);
  }
  for (const glm::dvec2& p : x) EXPECT_NEAR(std::hypot(p.x, p.y), 0, 1e-6);
}

}  // namespace
}  // namespace capcon
