#include "tiling/mean_tile.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace capcon {
namespace {

using Complex = std::complex<double>;

// exp(-2 pi i x) for |x| <= 1 from its power series: the same bits everywhere, which libm does not promise.
Complex turn(double x) {
  const double angle = -2 * 3.141592653589793 * (x - std::floor(x + 0.5)) / 4;
  double c = 1, s = angle, term = angle;
  for (int k = 2; k < 22; k += 2) {
    const double even = term * angle / k;
    c += (k % 4 == 0 ? even : -even);
    term = even * angle / (k + 1);
    s += (k % 4 == 0 ? term : -term);
  }
  const Complex quarter(c, s), half(c * c - s * s, 2 * c * s);
  return {half.real() * half.real() - half.imag() * half.imag(), 2 * half.real() * half.imag()};
}

Complex times(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

// Calls visit(m, n, F, terms) for one of each pair of opposite frequencies.
template <typename Visit>
void for_each_frequency(const TiedPoints& points, double reach, Visit visit) {
  const int top = int(std::floor(reach));
  const std::size_t count = points.free.size();
  // powers[(m + top) * count + i] = exp(-2 pi i m x_i)
  std::vector<Complex> in_x((2 * top + 1) * count), in_y((2 * top + 1) * count), terms(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Complex x = turn(points.free[i].position.x), y = turn(points.free[i].position.y);
    Complex px = 1, py = 1;
    for (int m = 0; m <= top; ++m, px = times(px, x), py = times(py, y)) {
      in_x[(top + m) * count + i] = px, in_x[(top - m) * count + i] = std::conj(px);
      in_y[(top + m) * count + i] = py, in_y[(top - m) * count + i] = std::conj(py);
    }
  }
  for (int n = 0; n <= top; ++n)
    for (int m = n == 0 ? 1 : -top; m <= top; ++m) {
      if (m * m + n * n > reach * reach) continue;
      Complex sum = 0;
      for (std::size_t i = 0; i < count; ++i) {
        terms[i] =
            times(in_x[(m + top) * count + i], in_y[(n + top) * count + i]) * points.free[i].copies_per_tile;
        sum += terms[i];
      }
      visit(m, n, sum, terms);
    }
}

}  // namespace

double mean_tile_unevenness(const TiedPoints& points, double reach, std::vector<glm::dvec2>* gradient,
                            bool low_first) {
  double total = 0;
  if (gradient) gradient->assign(points.free.size(), glm::dvec2(0));
  for_each_frequency(points, reach, [&](int m, int n, Complex sum, const std::vector<Complex>& terms) {
    const double weight = low_first ? reach * reach / (m * m + n * n) : 1.0;
    total += 2 * weight * std::norm(sum);
    if (!gradient) return;
    // d|F|^2 / dx = 2 Re(conj(F) * -2 pi i m * term) = 4 pi m Im(conj(F) * term)
    for (std::size_t i = 0; i < terms.size(); ++i)
      (*gradient)[i] +=
          weight * (2 * 4 * 3.141592653589793 * times(std::conj(sum), terms[i]).imag()) * glm::dvec2(m, n);
  });
  return total;
}

double mean_tile_peak(const TiedPoints& points, double reach) {
  double peak = 0;
  for_each_frequency(points, reach, [&](int, int, Complex sum, const std::vector<Complex>&) {
    peak = std::max(peak, std::norm(sum));
  });
  return peak;
}

}  // namespace capcon
