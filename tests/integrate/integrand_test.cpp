#include "integrate/integrand.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "base/error.h"
#include "integrate/estimator.h"

namespace capcon::integrate {
namespace {

using std::numbers::pi;

double value(const Draw& draw, glm::dvec2 p) {
  return draw.average(std::span(&p, 1), {});
}

/// Nodes and weights of Gauss and Legendre's rule on [0, 1], by Newton's method on the polynomial.
struct Gauss {
  std::vector<double> x, w;
  explicit Gauss(int order) {
    for (int i = 0; i < order; ++i) {
      double t = std::cos(pi * (i + 0.75) / (order + 0.5)), slope = 0;
      for (int step = 0; step < 50; ++step) {
        double p = 1, before = 0;
        for (int k = 1; k <= order; ++k)
          before = std::exchange(p, ((2 * k - 1) * t * p - (k - 1) * before) / k);
        slope = order * (t * p - before) / (t * t - 1);
        t -= p / slope;
      }
      x.push_back((1 - t) / 2);
      w.push_back(1 / ((1 - t * t) * slope * slope));
    }
  }
};

struct Moments {
  double mean = 0, square = 0;
};

/// Mean and mean square of f over the domain by panels of a high-order rule. Lines along which f jumps or
/// bends are found by bisection on each line of nodes: the inner integral is cut wherever f is not smooth.
Moments quadrature(const Draw& draw, Domain domain, bool pieces) {
  const Gauss rule(16);
  const int panels = pieces ? 256 : 16;
  Moments total;
  const auto inner = [&](auto line, double low, double high,
                         auto weight) {  // f along a line, cut at its jumps
    std::vector<double> cuts;
    for (int k = 0; k <= 8; ++k) cuts.push_back(low + (high - low) * k / 8);
    if (pieces) {
      constexpr int kSteps = 200;
      const auto at = [&](double t) { return value(draw, line(t)); };
      // A jump shows as a difference that does not shrink, a zero that starts or ends as a change of sign of
      // "f is 0" or "f is 1".
      const auto label = [&](double t) {
        const double v = at(t);
        return v == 0 ? 0 : v == 1 ? 2 : 1;
      };
      for (int k = 0; k < kSteps; ++k) {
        double a = low + (high - low) * k / kSteps, b = low + (high - low) * (k + 1) / kSteps;
        if (label(a) == label(b)) continue;
        const int left = label(a);
        for (int step = 0; step < 60; ++step) (label((a + b) / 2) == left ? a : b) = (a + b) / 2;
        cuts.push_back((a + b) / 2);
      }
      std::sort(cuts.begin(), cuts.end());
    }
    Moments sum;
    for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
      for (std::size_t k = 0; k < rule.x.size(); ++k) {
        const double t = cuts[c] + (cuts[c + 1] - cuts[c]) * rule.x[k];
        const double w = (cuts[c + 1] - cuts[c]) * rule.w[k] * weight(t), v = value(draw, line(t));
        sum.mean += w * v;
        sum.square += w * v * v;
      }
    }
    return sum;
  };
  for (int panel = 0; panel < panels; ++panel) {
    for (std::size_t k = 0; k < rule.x.size(); ++k) {
      const double u = (panel + rule.x[k]) / panels;
      Moments row;
      if (domain == Domain::disk) {  // along radii, at angle 2 pi u
        const glm::dvec2 d(std::cos(2 * pi * u), std::sin(2 * pi * u));
        row = inner([&](double r) { return r * d; }, 0, 1, [](double r) { return 2 * r; });
      } else {
        row = inner([&](double y) { return glm::dvec2(u, y); }, 0, 1, [](double) { return 1.0; });
      }
      total.mean += row.mean * rule.w[k] / panels;
      total.square += row.square * rule.w[k] / panels;
    }
  }
  return total;
}

TEST(Integrand, IntegralsAndDeviationsAgreeWithQuadrature) {
  for (const Integrand& integrand : battery()) {
    const bool pieces = integrand.family && integrand.name != "smooth-disk";
    for (std::uint64_t trial = 0; trial < (integrand.family ? 4 : 1); ++trial) {
      const Draw draw = integrand.draw(7, trial);
      const Moments m = quadrature(draw, integrand.domain, pieces);
      // Where lines of nodes touch a curve the inner integral has a root in it: fewer digits.
      const double tolerance = pieces ? 1e-5 : 1e-12;
      EXPECT_NEAR(draw.integral, m.mean, tolerance) << integrand.name << " trial " << trial;
      EXPECT_NEAR(draw.sigma * draw.sigma, m.square - m.mean * m.mean, tolerance)
          << integrand.name << " trial " << trial;
    }
  }
}

// Hardy and Krause's variation as the limit of its definition: mixed differences on a grid, and those along
// the sides x = 1, y = 1.
TEST(Integrand, VariationsAgreeWithTheirDefinition) {
  constexpr int kSteps = 1500;
  for (const Integrand& integrand : battery()) {
    const Draw draw = integrand.draw(3, 1);
    if (!draw.variation) continue;
    std::vector<double> f((kSteps + 1) * (kSteps + 1));
    const auto at = [&](int i, int j) -> double& {
      return f[static_cast<std::size_t>(i) * (kSteps + 1) + j];
    };
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; j <= kSteps; ++j) at(i, j) = value(draw, {double(i) / kSteps, double(j) / kSteps});
    }
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      sum += std::abs(at(i + 1, kSteps) - at(i, kSteps)) + std::abs(at(kSteps, i + 1) - at(kSteps, i));
      for (int j = 0; j < kSteps; ++j)
        sum += std::abs(at(i + 1, j + 1) - at(i, j + 1) - at(i + 1, j) + at(i, j));
    }
    EXPECT_NEAR(sum / *draw.variation, 1, 0.01) << integrand.name;
  }
}

// The suprema, by differences on a grid: never larger than stated, and reached.
TEST(Integrand, DerivativeBoundsAreTheSmallestThereAre) {
  constexpr int kSteps = 500;
  for (const Integrand& integrand : battery()) {
    const Draw draw = integrand.draw(3, 1);
    if (!draw.smooth) continue;
    double gradient = 0, hessian = 0;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; j <= kSteps; ++j) {
        constexpr double h = 1e-4;  // f is smooth beyond the square's sides too
        const glm::dvec2 p(double(i) / kSteps, double(j) / kSteps), x(h, 0), y(0, h);
        const auto f = [&](glm::dvec2 q) { return value(draw, q); };
        const glm::dvec2 g((f(p + x) - f(p - x)) / (2 * h), (f(p + y) - f(p - y)) / (2 * h));
        const double xx = (f(p + x) - 2 * f(p) + f(p - x)) / (h * h),
                     yy = (f(p + y) - 2 * f(p) + f(p - y)) / (h * h);
        const double xy = (f(p + x + y) - f(p + x - y) - f(p - x + y) + f(p - x - y)) / (4 * h * h);
        gradient = std::max(gradient, glm::length(g));
        hessian = std::max(hessian, std::abs(xx + yy) / 2 + std::hypot((xx - yy) / 2, xy));
      }
    }
    EXPECT_NEAR(gradient / draw.smooth->gradient, 1, 1e-3) << integrand.name;
    EXPECT_NEAR(hessian / draw.smooth->hessian, 1, 1e-3) << integrand.name;
  }
}

// A density integrates to 1, its places follow it, and f / density has the stated deviation: all by the same
// rule, in the variables of the uniform square and in those of the density.
TEST(Integrand, ImportanceDensitiesBelongToTheirPlaces) {
  const Gauss rule(64);
  for (const Integrand& integrand : battery()) {
    if (!integrand.importance) continue;
    const Importance& importance = *integrand.importance;
    const Draw draw = integrand.draw(1, 0);
    double mass = 0, placed = 0, direct = 0, ratio2 = 0;
    constexpr int kPanels = 16;
    for (int i = 0; i < 64 * kPanels; ++i) {
      for (int j = 0; j < 64 * kPanels; ++j) {
        const double w = rule.w[i % 64] * rule.w[j % 64] / (kPanels * kPanels);
        const glm::dvec2 u((i / 64 + rule.x[i % 64]) / kPanels, (j / 64 + rule.x[j % 64]) / kPanels);
        const glm::dvec2 p = importance.place(u);
        const auto probe = [](glm::dvec2 q) { return std::cos(3 * q.x + q.x * q.y) + q.y * q.y; };
        mass += w * importance.value(u);
        placed += w * probe(p);
        direct += w * probe(u) * importance.value(u);
        ratio2 += w * std::pow(value(draw, u), 2) / importance.value(u);
      }
    }
    EXPECT_NEAR(mass, 1, 1e-6) << integrand.name;
    EXPECT_NEAR(placed, direct, 1e-6) << integrand.name;
    EXPECT_NEAR(importance.sigma, std::sqrt(ratio2 - draw.integral * draw.integral), 1e-5) << integrand.name;
    EXPECT_LT(importance.sigma, draw.sigma) << integrand.name;  // else it is not worth its name
  }
}

TEST(Integrand, FamiliesDependOnSeedAndTrialAlone) {
  for (const Integrand& integrand : battery()) {
    const double first = integrand.draw(5, 17).average(std::vector<glm::dvec2>{{0.2, 0.3}, {0.7, 0.6}}, {});
    EXPECT_EQ(first, integrand.draw(5, 17).average(std::vector<glm::dvec2>{{0.2, 0.3}, {0.7, 0.6}}, {}));
    EXPECT_EQ(integrand.draw(5, 17).integral == integrand.draw(5, 18).integral,
              !integrand.family || integrand.name == "leaves")
        << integrand.name;
  }
}

TEST(Integrand, UnknownNamesListTheKnownOnes) {
  for (const auto& look : {+[] { find_integrand("dsik"); }, +[] { find_estimator("dsik"); }}) {
    try {
      look();
      FAIL();
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_TRUE(message.find("half-plane") != std::string::npos ||
                  message.find("sobol-owen") != std::string::npos);
    }
  }
}

}  // namespace
}  // namespace capcon::integrate
