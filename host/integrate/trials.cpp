#include "integrate/trials.h"

#include "points/discrepancy.h"
#include "reference/hemisphere.h"

namespace capcon::integrate {

double TrialPoints::estimate(const Integrand& integrand, const Draw& draw, Weights weights) {
  if (weights == Weights::importance) {
    Points places;
    std::vector<double> shares;
    for (const glm::dvec2 u : points_) {
      places.push_back(integrand.importance->place(u));
      shares.push_back(1 /
                       (static_cast<double>(points_.size()) * integrand.importance->value(places.back())));
    }
    return draw.average(places, shares);
  }
  const Points& places = integrand.domain == Domain::disk ? on_disk() : points_;
  if (weights == Weights::areas) return draw.average(places, cells(integrand.domain).areas);
  return draw.average(places, {});
}

const CellSums& TrialPoints::cells(Domain domain) {
  std::optional<CellSums>& sums = domain == Domain::torus ? torus_ : square_;
  if (!sums) {
    if (!cells_) cells_ = source_.cells(points_, trial_);
    sums = domain == Domain::torus ? torus_sums(*cells_) : square_sums(points_, *cells_);
  }
  return *sums;
}

double TrialPoints::discrepancy() {
  if (!discrepancy_) discrepancy_ = star_discrepancy(points_);
  return *discrepancy_;
}

const Points& TrialPoints::on_disk() {
  if (disk_.empty()) {
    disk_.reserve(points_.size());
    for (const glm::dvec2 p : points_) disk_.push_back(reference::concentric_disk(p.x, p.y));
  }
  return disk_;
}

}  // namespace capcon::integrate
