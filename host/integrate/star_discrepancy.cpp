#include "integrate/star_discrepancy.h"

#include <algorithm>

namespace capcon::integrate {

double star_discrepancy(const Points& points) {
  const std::size_t n = points.size();
  if (n == 0) return 1;
  Points sorted = points;
  std::sort(sorted.begin(), sorted.end(), [](glm::dvec2 a, glm::dvec2 b) { return a.x < b.x; });
  const double share = 1 / static_cast<double>(n);
  std::vector<double> ys{0, 1};  // of the l points with the smallest x, between the square's sides
  double largest = 0;
  for (std::size_t l = 0;; ++l) {
    // Boxes whose right side lies from x_l to x_{l+1}: the closed one of the first, the open one of the
    // second.
    const double left = l == 0 ? 0 : sorted[l - 1].x, right = l == n ? 1 : sorted[l].x;
    for (std::size_t k = 0; k <= l; ++k) {
      const double inside = static_cast<double>(k) * share;
      largest = std::max(largest, std::max(inside - left * ys[k], right * ys[k + 1] - inside));
    }
    if (l == n) return largest;
    ys.insert(std::upper_bound(ys.begin() + 1, ys.end() - 1, sorted[l].y), sorted[l].y);
  }
}

}  // namespace capcon::integrate
