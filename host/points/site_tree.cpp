#include "points/site_tree.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

namespace capcon {

namespace {

std::vector<std::uint32_t> all(std::size_t n) {
  std::vector<std::uint32_t> items(n);
  std::iota(items.begin(), items.end(), 0u);
  return items;
}

}  // namespace

SiteTree::SiteTree(const Points& sites, bool torus)
    : sites_(sites),
      torus_(torus),
      tree_(sites, all(sites.size())),
      leaf_(sites.size()),
      closed_(sites.size(), false) {
  const auto& nodes = tree_.nodes();
  open_.resize(nodes.size());
  parent_.assign(nodes.size(), 0);
  for (std::uint32_t n = 0; n < nodes.size(); ++n) {
    open_[n] = nodes[n].count;
    if (nodes[n].left != 0) {
      parent_[nodes[n].left] = parent_[nodes[n].left + 1] = n;
    } else {
      for (std::uint32_t k = 0; k < nodes[n].count; ++k) leaf_[tree_.items()[nodes[n].first + k]] = n;
    }
  }
}

void SiteTree::close(std::uint32_t i) {
  closed_[i] = true;
  for (std::uint32_t n = leaf_[i];; n = parent_[n]) {
    --open_[n];
    if (n == 0) return;
  }
}

double SiteTree::distance2(glm::dvec2 p, std::uint32_t i) const {
  glm::dvec2 d = p - sites_[i];
  if (torus_) d -= glm::round(d);
  return glm::dot(d, d);
}

void SiteTree::look(glm::dvec2 p, std::uint32_t n, Best& best) const {
  const KdTree::Node& node = tree_.nodes()[n];
  if (node.left == 0) {
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
      const std::uint32_t i = tree_.items()[k];
      const glm::dvec2 d = p - sites_[i];
      if (!closed_[i] && glm::dot(d, d) < best.distance2) best = {glm::dot(d, d), i};
    }
    return;
  }
  std::uint32_t near = node.left, far = node.left + 1;
  const auto bound = [&](std::uint32_t child) {
    const KdTree::Node& c = tree_.nodes()[child];
    return open_[child] > 0 ? box_distance2(p, c.low, c.high) : std::numeric_limits<double>::infinity();
  };
  double near2 = bound(near), far2 = bound(far);
  if (far2 < near2) std::swap(near, far), std::swap(near2, far2);
  if (near2 < best.distance2) look(p, near, best);
  if (far2 < best.distance2) look(p, far, best);
}

std::uint32_t SiteTree::nearest(glm::dvec2 p) const {
  Best best{std::numeric_limits<double>::infinity(), 0};
  look(p, 0, best);
  if (!torus_) return best.site;
  const KdTree::Node& root = tree_.nodes()[0];
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      const glm::dvec2 image = p + glm::dvec2(x, y);
      if ((x != 0 || y != 0) && box_distance2(image, root.low, root.high) < best.distance2)
        look(image, 0, best);
    }
  }
  return best.site;
}

}  // namespace capcon
