#include "points/ccvt_leads.h"

#include <algorithm>
#include <cmath>

namespace capcon {

namespace {

// Longest lead, as part of a cell's reach: under a tenth of the way to the next site. Longer ones stir up
// what has come about.
constexpr double kLongest = 0.12;

}  // namespace

void CcvtLeads::set(CcvtCells& cells, std::size_t i, double x, double y) const {
  CcvtSite& site = cells.sites[i];
  const double old_x = site.x, old_y = site.y;
  site.lead_x = x;
  site.lead_y = y;
  cells.place(i);
  if (site.x != old_x || site.y != old_y) site.travel += 1 + std::hypot(site.x - old_x, site.y - old_y);
}

void CcvtLeads::renew(CcvtCells& cells) {
  if (factor_ == 0) return;
  const bool first = before_.empty();
  before_.resize(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const CcvtSite& site = cells.sites[i];
    const auto round = [](double v) { return static_cast<std::uint32_t>(std::llround(v)); };
    const TorusPoint now{site.centre.x + round(site.x - site.lead_x),
                         site.centre.y + round(site.y - site.lead_y)};
    if (!first) {
      double x = factor_ * difference(now.x, before_[i].x), y = factor_ * difference(now.y, before_[i].y);
      const double length = std::hypot(x, y), longest = kLongest * site.reach;
      if (length > longest) x *= longest / length, y *= longest / length;
      set(cells, i, x, y);
    }
    before_[i] = now;
  }
}

void CcvtLeads::end(CcvtCells& cells) const {
  if (factor_ == 0) return;
  for (std::size_t i = 0; i < cells.size(); ++i) set(cells, i, 0, 0);
}

}  // namespace capcon
