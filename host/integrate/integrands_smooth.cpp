#include <cmath>
#include <numbers>

#include "integrate/integrand.h"

namespace capcon::integrate {
namespace {

using std::numbers::e;
using std::numbers::pi;

/// One factor g of f(x, y) = g(x) h(y) on [0, 1].
struct Factor {
  double variation;  ///< total variation of g
  double at_one;     ///< |g(1)|
};

/// Hardy and Krause's variation of a product: Vitali's term, and what is left on the sides x = 1 and y = 1.
double product_variation(const Factor& g, const Factor& h) {
  return g.variation * h.variation + g.variation * h.at_one + h.variation * g.at_one;
}

Integrand fixed(std::string name, std::string title, std::string formula, Domain domain, Draw draw) {
  Integrand integrand{
      std::move(name), std::move(title), std::move(formula), domain, false, false, {}, {}, {}, {}};
  integrand.draw = [draw = std::move(draw)](std::uint64_t, std::uint64_t) { return draw; };
  return integrand;
}

Integrand smooth_periodic() {
  const double mean = std::pow(std::cyl_bessel_i(0.0, 1.0), 2);
  const double square = std::pow(std::cyl_bessel_i(0.0, 2.0), 2);
  const Factor g{2 * (e - 1 / e), e};
  // |grad f| = 2 pi exp(c1 + c2) sqrt(s1^2 + s2^2) is largest at c1 = c2 = c with 2 (1 - c^2) = c. The matrix
  // of second derivatives is 4 pi^2 f (s s^T - diag(c1, c2)); its norm is largest at f's maximum, where s = 0
  // and c = 1.
  const double c = (std::sqrt(17.0) - 1) / 4;
  const Smoothness smooth{2 * pi * std::exp(2 * c) * std::sqrt(2 * (1 - c * c)), 4 * pi * pi * e * e};
  Integrand result = fixed(
      "smooth-periodic", "Smooth and periodic",
      "f = exp(cos 2πx + cos 2πy); the integral is I₀(1)², I₀ the modified Bessel function.", Domain::torus,
      {average_of([](glm::dvec2 p) { return std::exp(std::cos(2 * pi * p.x) + std::cos(2 * pi * p.y)); }),
       mean, std::sqrt(square - mean * mean), product_variation(g, g), smooth});
  result.no_importance = "a density like exp(cos) has no inverse in closed form";
  return result;
}

Integrand smooth() {
  const double mean = (e - 1) / 3;
  // The entries of the matrix of second derivatives grow with x and y: the norm is that at (1,1), e (3 + sqrt
  // 17) / 2.
  const Smoothness bounds{e * std::sqrt(5.0), e * (3 + std::sqrt(17.0)) / 2};
  Integrand result =
      fixed("smooth", "Smooth, not periodic", "f = exp(x) y²; the integral is (e − 1)/3.", Domain::square,
            {average_of([](glm::dvec2 p) { return std::exp(p.x) * p.y * p.y; }), mean,
             std::sqrt((e * e - 1) / 10 - mean * mean), product_variation({e - 1, e}, {1, 1}), bounds});
  const double square = std::exp(-2) * (std::expint(4.0) - std::expint(2.0)) * 1.5 / 9;
  result.importance = Importance{
      "2(1 + x) y²", [](glm::dvec2 u) { return glm::dvec2(std::sqrt(1 + 3 * u.x) - 1, std::cbrt(u.y)); },
      [](glm::dvec2 p) { return (1 + p.x) / 1.5 * 3 * p.y * p.y; }, std::sqrt(square - mean * mean)};
  return result;
}

Integrand product() {
  Integrand result = fixed("product", "Product", "f = 4xy; the integral is 1.", Domain::square,
                           {average_of([](glm::dvec2 p) { return 4 * p.x * p.y; }), 1, std::sqrt(7.0) / 3,
                            product_variation({2, 2}, {2, 2}), Smoothness{4 * std::sqrt(2.0), 4}});
  const double factor = std::log(3.0);  // integral of (2x)^2 / (1/2 + x)
  const auto place = [](double u) { return (std::sqrt(1 + 8 * u) - 1) / 2; };
  result.importance =
      Importance{"(½ + x)(½ + y)", [place](glm::dvec2 u) { return glm::dvec2(place(u.x), place(u.y)); },
                 [](glm::dvec2 p) { return (0.5 + p.x) * (0.5 + p.y); }, std::sqrt(factor * factor - 1)};
  return result;
}

/// One axis of the peak: exp(-(x - c)^2 / (2 s^2)) on [0, 1], and the density 1 / (1 + ((x - c)/s)^2),
/// normalised.
struct Bump {
  double centre, width;
  double low = -centre / width, high = (1 - centre) / width;

  double value(double x) const { return std::exp(-0.5 * std::pow((x - centre) / width, 2)); }
  /// Integral of value^power, power 1 or 2.
  double integral(int power) const {
    const double k = std::sqrt(power / 2.0);
    return width * std::sqrt(pi) / (2 * k) * (std::erf(k * high) - std::erf(k * low));
  }
  Factor factor() const { return {2 - value(0) - value(1), value(1)}; }
  double norm() const { return width * (std::atan(high) - std::atan(low)); }
  double density(double x) const { return 1 / (norm() * (1 + std::pow((x - centre) / width, 2))); }
  double place(double u) const {
    const double x = centre + width * std::tan(std::atan(low) + u * (std::atan(high) - std::atan(low)));
    return std::min(std::max(x, 0.0), 1.0);
  }
  /// Integral of value^2 / density: of norm s exp(-t^2) (1 + t^2).
  double square_over_density() const {
    const auto primitive = [](double t) {
      return 0.75 * std::sqrt(pi) * std::erf(t) - 0.5 * t * std::exp(-t * t);
    };
    return norm() * width * (primitive(high) - primitive(low));
  }
};

Integrand peak() {
  const Bump a{0.37, 0.1}, b{0.62, 0.1};
  const double mean = a.integral(1) * b.integral(1);
  Integrand result = fixed(
      "peak", "Peak",
      "f = exp(−|p − c|²/(2s²)), c = (0.37, 0.62), s = 0.1; the integral is a product of error functions.",
      Domain::square,
      {average_of([a, b](glm::dvec2 p) {
         const double u = (p.x - a.centre) / a.width, v = (p.y - b.centre) / b.width;
         return std::exp(-0.5 * (u * u + v * v));
       }),
       mean, std::sqrt(a.integral(2) * b.integral(2) - mean * mean),
       product_variation(a.factor(), b.factor()),
       Smoothness{std::exp(-0.5) / a.width, 1 / (a.width * a.width)}});
  result.importance = Importance{"two Cauchy factors of the peak's place and width",
                                 [a, b](glm::dvec2 u) { return glm::dvec2(a.place(u.x), b.place(u.y)); },
                                 [a, b](glm::dvec2 p) { return a.density(p.x) * b.density(p.y); },
                                 std::sqrt(a.square_over_density() * b.square_over_density() - mean * mean)};
  return result;
}

}  // namespace

std::vector<Integrand> smooth_integrands() {
  return {smooth_periodic(), smooth(), product(), peak()};
}

}  // namespace capcon::integrate
