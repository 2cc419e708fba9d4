#pragma once

#include "points/laplacian.h"
#include "points/point_set.h"
#include "points/power_diagram.h"

namespace capcon {

/// Weights for which every power cell has its share of the unit torus: the cheapest way to carry the uniform
/// density to the sites (Aurenhammer, Hoffmann, Aronov 1998). By Newton steps on the weights, shortened until
/// no cell comes near to vanishing (Kitagawa, Merigot, Thibert 2019): the areas' derivatives are d a_i / d
/// w_j = -l_ij / (2 d_ij), l the length of the edge between two cells, d the distance of their sites.
class Transport {
 public:
  /// Sites in [-0.5, 1.5)^2, no two in the same place; `shares` sum to 1.
  Transport(Points sites, std::vector<double> shares);
  /// The same from weights that are nearly right.
  Transport(Points sites, std::vector<double> shares, std::vector<double> weights);

  /// Newton steps until every cell's area is its share but for `tolerance` of it. Failure if that does not
  /// come about.
  void balance(double tolerance);

  const Points& sites() const { return sites_; }
  const std::vector<double>& weights() const { return weights_; }
  const PowerDiagram& diagram() const { return diagram_; }
  /// Integral of |p - its site|^2 over the torus.
  double cost() const;
  /// Largest |area / share - 1|.
  double area_error() const;

 private:
  Points sites_;
  std::vector<double> shares_, weights_;
  PowerDiagram diagram_;
};

/// The matrix of -d area_i / d weight_j.
Laplacian area_derivatives(const PowerDiagram& diagram, std::span<const glm::dvec2> sites);

/// E_ot: n times the least transport cost from the uniform density to n equal masses at the points, over
/// kHexagonEnergy: 1 = hexagons. Any points in [0, 1)^2, coinciding ones too (those nearer than 1e-7 of the
/// mean spacing are treated as one of that many masses). 0 for no points. Failure if Newton's method does not
/// end: known of several clusters at once that are 1e-6 wide and flatter still.
double transport_energy(const Points& points);

}  // namespace capcon
