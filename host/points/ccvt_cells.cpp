#include "points/ccvt_cells.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "points/ccvt_keys.h"

namespace capcon {

namespace {

/// Coordinates of points one after another.
std::vector<std::uint32_t> column(const std::vector<TorusPoint>& points, std::uint32_t TorusPoint::*axis) {
  std::vector<std::uint32_t> list(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) list[k] = points[k].*axis;
  return list;
}

}  // namespace

CcvtCells::CcvtCells(std::uint32_t capacity, const std::vector<TorusPoint>& points)
    : CcvtCells(capacity, column(points, &TorusPoint::x), column(points, &TorusPoint::y)) {}

CcvtCells::CcvtCells(std::uint32_t capacity, std::vector<std::uint32_t> x_list,
                     std::vector<std::uint32_t> y_list)
    : sites(x_list.size() / capacity), capacity_(capacity), x_(std::move(x_list)), y_(std::move(y_list)) {
  // The inscribed circle of a hexagonal cell has the radius sqrt(1 / (2 sqrt 3 n)). A little less leaves out
  // the points that no neighbour of a settled cell can want.
  inner_radius_ =
      static_cast<float>(0.85 * 0x1p32 * std::sqrt(0.28867513459481287 / static_cast<double>(sites.size())));
  for (std::size_t i = 0; i < sites.size(); ++i) {
    sites[i].centre = {x(i)[0], y(i)[0]};
    sum_up(i);
    refit(i);
  }
}

void CcvtCells::sum_up(std::size_t i) {
  static const CcvtKernels kernels = best_ccvt_kernels();
  CcvtSite& site = sites[i];
  const double most = kernels.sum(x(i), y(i), capacity_, site.centre, site.sum_x, site.sum_y);
  site.reach = static_cast<float>(1.5 * most);  // sqrt 2, and rounding
  place(i);
}

void CcvtCells::refit(std::size_t i) {
  CcvtSite& site = sites[i];
  std::uint32_t* const px = x(i);
  std::uint32_t* const py = y(i);
  // Nearest images may change with the centre of a large cell: each round then lowers the energy.
  for (int round = 0; round < 100; ++round) {
    const auto step_x = std::llround(site.x), step_y = std::llround(site.y);
    if (round > 0 && step_x == 0 && step_y == 0) break;
    site.centre.x += static_cast<std::uint32_t>(step_x);
    site.centre.y += static_cast<std::uint32_t>(step_y);
    if (!is_large(i)) {
      site.sum_x -= step_x * capacity_;
      site.sum_y -= step_y * capacity_;
      place(i);
      break;
    }
    sum_up(i);
  }
  const float limit2 = inner_radius_ * inner_radius_;
  float reach2 = 0;
  std::uint32_t outer = 0;
  for (std::uint32_t k = 0; k < capacity_; ++k) {
    const auto dx = static_cast<float>(difference(px[k], site.centre.x));
    const auto dy = static_cast<float>(difference(py[k], site.centre.y));
    const float distance2 = dx * dx + dy * dy;
    reach2 = std::max(reach2, distance2);
    // Without a branch: the slot trades places with the first inner one, or with itself.
    const std::uint32_t to = distance2 > limit2 ? outer : k;
    std::swap(px[k], px[to]);
    std::swap(py[k], py[to]);
    outer += distance2 > limit2;
  }
  site.outer = outer;
  // A hair more than the rounded distances, so that they are bounds.
  site.inner = inner_radius_ * 1.000001f;
  site.reach = std::sqrt(reach2) * 1.000001f;
}

double CcvtCells::energy() const {
  double total = 0;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    double sum = 0;
    for (std::uint32_t k = 0; k < capacity_; ++k) {
      double dx = difference(x(i)[k], sites[i].centre.x) - sites[i].x;
      double dy = difference(y(i)[k], sites[i].centre.y) - sites[i].y;
      sum += dx * dx + dy * dy;
    }
    total += sum;
  }
  return total * 0x1p-64 / capacity_;
}

}  // namespace capcon
