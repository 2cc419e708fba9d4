#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace capcon {

/// A site near another one, seen from there.
struct Neighbour {
  glm::dvec2 offset{0};  ///< where it lies
  double distance2 = 0;  ///< |offset|^2
  std::uint32_t site = 0;
  glm::dvec2 tile{0};  ///< of its tile relative to this one's
};

/// The cell of a site in a power diagram (Aurenhammer 1987): all x with |x|^2 - w <= |x - offset|^2 -
/// w_neighbour. Equal weights give the Voronoi cell; raising a site's weight makes its cell larger.
struct PowerCell {
  struct Wall {
    std::uint32_t site;
    double slope;  ///< derivative of the cell's area by -w of that neighbour: length / (2 distance)
  };
  double area = 0;
  glm::dvec2 centroid{0};    ///< relative to the site
  double second_moment = 0;  ///< integral of |x - site|^2
  std::vector<Wall> walls;
};

/// A rectangle around a site.
struct SiteBox {
  glm::dvec2 low{-1}, high{1};
};

/// Clips a box (at most [-1, 1]^2) around a site by the neighbours, which are sorted by distance. `weights`
/// is indexed by site.
void clip_power_cell(const std::vector<Neighbour>& neighbours, double own_weight,
                     const std::vector<double>& weights, PowerCell& cell, const SiteBox& box = {});

}  // namespace capcon
