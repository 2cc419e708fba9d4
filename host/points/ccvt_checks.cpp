#include "points/ccvt_checks.h"

#include <cmath>
#include <glm/vec2.hpp>

#include "base/hash.h"
#include "points/checks.h"

namespace capcon {
namespace {

struct Sums {
  std::int64_t x = 0, y = 0;
};

/// Of the points of site s, relative to `centre`.
Sums sums_about(const CcvtCells& cells, std::size_t s, TorusPoint centre) {
  Sums sums;
  for (std::uint32_t k = 0; k < cells.capacity(); ++k) {
    sums.x += difference(cells.x(s)[k], centre.x);
    sums.y += difference(cells.y(s)[k], centre.y);
  }
  return sums;
}

}  // namespace

std::uint64_t content_of(const std::uint32_t* x, const std::uint32_t* y, std::size_t count) {
  std::uint64_t sum = 0;
  for (std::size_t k = 0; k < count; ++k) sum += mix64(1, x[k], y[k]);
  return sum;
}

ExchangeCheck::ExchangeCheck(const CcvtCells& cells, std::size_t i, std::size_t j)
    : cells_(cells),
      i_(i),
      j_(j),
      content_(content_of(cells.x(i), cells.y(i), cells.capacity()) +
               content_of(cells.x(j), cells.y(j), cells.capacity())),
      before_i_(look(i)),
      before_j_(look(j)) {}

ExchangeCheck::Before ExchangeCheck::look(std::size_t s) const {
  const CcvtSite& site = cells_.sites[s];
  const Sums sums = sums_about(cells_, s, site.centre);
  return {site, cells_.is_large(s), sums.x, sums.y, distances(s, site), own_energy(s)};
}

ExchangeCheck::Wide ExchangeCheck::distances(std::size_t s, const CcvtSite& site) const {
  const TorusPoint place{site.centre.x + static_cast<std::uint32_t>(std::llround(site.x)),
                         site.centre.y + static_cast<std::uint32_t>(std::llround(site.y))};
  Wide sum = 0;
  for (std::uint32_t k = 0; k < cells_.capacity(); ++k) {
    const Wide x = difference(cells_.x(s)[k], place.x), y = difference(cells_.y(s)[k], place.y);
    sum += x * x + y * y;
  }
  return sum;
}

ExchangeCheck::Wide ExchangeCheck::own_energy(std::size_t s) const {
  const CcvtSite& site = cells_.sites[s];
  Wide squares = 0, sum_x = 0, sum_y = 0;
  for (std::uint32_t k = 0; k < cells_.capacity(); ++k) {
    const Wide x = difference(cells_.x(s)[k], site.centre.x), y = difference(cells_.y(s)[k], site.centre.y);
    squares += x * x + y * y;
    sum_x += x;
    sum_y += y;
  }
  return cells_.capacity() * squares - sum_x * sum_x - sum_y * sum_y;
}

void ExchangeCheck::check_site(std::size_t s) const {
  const CcvtSite& site = cells_.sites[s];
  const Sums sums = sums_about(cells_, s, site.centre);
  require(sums.x == site.sum_x && sums.y == site.sum_y, "ccvt: a site's sums are not those of its points");
  require(site.x == static_cast<double>(sums.x) / cells_.capacity() + site.lead_x &&
              site.y == static_cast<double>(sums.y) / cells_.capacity() + site.lead_y,
          "ccvt: a site is not at the centroid of its points");
  for (std::uint32_t k = 0; k < cells_.capacity(); ++k) {
    const double distance =
        std::hypot(difference(cells_.x(s)[k], site.centre.x), difference(cells_.y(s)[k], site.centre.y));
    require(distance <= site.reach, "ccvt: a point is beyond its site's reach");
    require(k < site.outer || distance <= site.inner, "ccvt: an inner slot holds an outer point");
  }
}

void ExchangeCheck::end(std::uint32_t count) const {
  if (count == 0) return;
  const std::uint32_t capacity = cells_.capacity();
  require(
      content_of(cells_.x(i_), cells_.y(i_), capacity) + content_of(cells_.x(j_), cells_.y(j_), capacity) ==
          content_,
      "ccvt: an exchange lost or doubled a space point");
  check_site(i_);
  check_site(j_);
  const Before &a = before_i_, &b = before_j_;
  const auto as_double = [](Wide v) { return static_cast<double>(v); };
  if (a.large || b.large) {
    const Wide rise = distances(i_, a.site) + distances(j_, b.site) - a.at_site - b.at_site;
    require(rise < 0, "ccvt: an exchange raised the energy for the sites as they stood");
  } else {
    // Points keep their images, so what one site's sum gains the other's loses, and the energy changes by
    // twice the product of that with the way from site to site.
    const Sums now_i = sums_about(cells_, i_, a.site.centre), now_j = sums_about(cells_, j_, b.site.centre);
    const std::int64_t to_i_x = now_i.x - a.sum_x, to_i_y = now_i.y - a.sum_y;
    require(to_i_x == b.sum_x - now_j.x && to_i_y == b.sum_y - now_j.y,
            "ccvt: what came to a site is not what left the other");
    const long double way_x = difference(b.site.centre.x, a.site.centre.x) + b.site.x - a.site.x;
    const long double way_y = difference(b.site.centre.y, a.site.centre.y) + b.site.y - a.site.y;
    require(way_x * static_cast<long double>(to_i_x) + way_y * static_cast<long double>(to_i_y) < 0,
            "ccvt: an exchange raised the energy for the sites as they stood");
  }
  const CcvtSite &s = cells_.sites[i_], &t = cells_.sites[j_];
  if (s.lead_x != 0 || s.lead_y != 0 || t.lead_x != 0 || t.lead_y != 0) return;
  const Wide before = a.own + b.own;
  check_step(Checked::kCcvt, as_double(own_energy(i_) + own_energy(j_) - before), 0, as_double(before));
}

}  // namespace capcon
