#include "points/power_diagram.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>

#include "base/parallel.h"
#include "points/power_search.h"

namespace capcon {

struct PowerScratch {
  PowerCell cell;
  std::vector<KdTree::Entry> queue;
};

struct PowerDiagram::Input {
  std::span<const glm::dvec2> sites;
  std::span<const double> weights;
  const PowerDiagram* older;
  const PowerSearch* search;
};

namespace {

/// The image of `to` as seen from the site itself, when `through` is an image seen from there. Empty where
/// that is farther off than any image that matters.
std::optional<SiteImage> seen_through(SiteImage through, SiteImage to) {
  const int x = through.x() + to.x(), y = through.y() + to.y();
  if (std::max(std::abs(x), std::abs(y)) > 2) return {};
  return SiteImage(to.site(), x, y);
}

}  // namespace

void PowerDiagram::cut(const Input& input, std::uint32_t i, Reach reach, PowerScratch& scratch) {
  PowerCell& cell = scratch.cell;
  cell.reset(i);
  const glm::dvec2 site = input.sites[i];
  const double weight = input.weights[i];
  const auto cut_by = [&](SiteImage image) {
    const std::uint32_t j = image.site();
    if (j == i) return;
    const glm::dvec2 d = (input.sites[j] - site) + glm::dvec2(image.x(), image.y());
    cell.cut(d, 0.5 * (glm::dot(d, d) + weight - input.weights[j]), image);
  };
  if (input.older != nullptr) {
    for (const Edge& edge : input.older->edges(i)) cut_by(edge.beyond);
    if (reach == Reach::kTheirNeighbours) {
      for (const Edge& edge : input.older->edges(i)) {
        for (const Edge& next : input.older->edges(edge.beyond.site())) {
          if (const auto image = seen_through(edge.beyond, next.beyond)) cut_by(*image);
        }
      }
    }
  }
  if (reach == Reach::kAll) input.search->cut(i, cell, scratch.queue);
  Cell& result = cells_[i];
  auto& edges = blocks_[i / kBlock];
  result.begin = static_cast<std::uint32_t>(edges.size());
  result.count = static_cast<std::uint32_t>(cell.size());
  result.moments = cell.moments();
  for (std::size_t k = 0; k < cell.size(); ++k) {
    const glm::dvec2 a = cell.corner(k), b = cell.corner(k + 1 < cell.size() ? k + 1 : 0);
    edges.push_back({cell.beyond(k), glm::length(b - a), 0.5 * (a + b)});
  }
}

bool PowerDiagram::cut_listed(const Input& input, const std::vector<std::uint32_t>& list, Reach reach,
                              double least_area) {
  // Tasks are the runs of the list that lie in one block: the block's edges belong to one thread.
  std::vector<std::size_t> start;
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (k == 0 || list[k] / kBlock != list[k - 1] / kBlock) start.push_back(k);
  }
  start.push_back(list.size());
  std::atomic<bool> fine = true;
  parallel_for(start.size() - 1, [&](std::size_t task) {
    PowerScratch scratch;
    for (std::size_t k = start[task]; k < start[task + 1] && fine; ++k) {
      cut(input, list[k], reach, scratch);
      if (!(cells_[list[k]].moments.area >= least_area)) fine = false;  // it can only shrink from here
    }
  });
  return fine;
}

std::vector<std::uint32_t> PowerDiagram::disagreeing(double tolerance) const {
  std::vector<std::uint8_t> bad(blocks_.size() * kBlock, 0);
  parallel_for(blocks_.size(), [&](std::size_t block) {
    for (std::size_t i = block * kBlock; i < std::min(size(), (block + 1) * kBlock); ++i) {
      for (const Edge& edge : edges(i)) {
        const SiteImage back(static_cast<std::uint32_t>(i), -edge.beyond.x(), -edge.beyond.y());
        double length = 0;
        for (const Edge& other : edges(edge.beyond.site())) {
          if (other.beyond == back) length += other.length;
        }
        if (!(std::abs(length - edge.length) <= tolerance)) bad[i] = 1;
      }
    }
  });
  // The edge that i sees and j does not, or sees shorter, is wrong in one of them: both are cut again.
  std::vector<std::uint8_t> both = bad;
  for (std::size_t i = 0; i < size(); ++i) {
    if (!bad[i]) continue;
    for (const Edge& edge : edges(i)) both[edge.beyond.site()] = 1;
  }
  std::vector<std::uint32_t> list;
  for (std::uint32_t i = 0; i < size(); ++i) {
    if (both[i]) list.push_back(i);
  }
  return list;
}

bool PowerDiagram::compute(std::span<const glm::dvec2> sites, std::span<const double> weights,
                           const PowerDiagram* older, double least_area) {
  cells_.assign(sites.size(), {});
  blocks_.resize((sites.size() + kBlock - 1) / kBlock);
  for (auto& edges : blocks_) edges.clear();
  Input input{sites, weights, older, nullptr};
  std::vector<std::uint32_t> all(sites.size());
  std::iota(all.begin(), all.end(), 0u);
  // A cut that is missed leaves an edge too many of the length square root of the area in excess: 1e-12 of a
  // cell's.
  const double tolerance = 1e-6 / std::sqrt(static_cast<double>(sites.size()));
  std::vector<std::uint32_t> wrong = all;
  if (older != nullptr) {
    if (!cut_listed(input, all, Reach::kNeighbours, least_area)) return false;
    for (int round = 0; round < 2; ++round) {
      wrong = disagreeing(tolerance);
      if (wrong.empty()) break;
      if (!cut_listed(input, wrong, Reach::kTheirNeighbours, least_area)) return false;
    }
    if (!wrong.empty()) wrong = disagreeing(tolerance);
    double area = 0;  // cells that are too large yet agree would cover the torus twice
    for (const Cell& cell : cells_) area += cell.moments.area;
    if (wrong.empty() && !(std::abs(area - 1) < 1e-9)) wrong = all;
    if (wrong.empty()) return true;
  }
  const PowerSearch search(sites, weights);
  input.search = &search;
  if (!cut_listed(input, wrong, Reach::kAll, least_area)) return false;
  if (wrong.size() < all.size() && !disagreeing(tolerance).empty()) {
    return cut_listed(input, all, Reach::kAll, least_area);
  }
  return true;
}

}  // namespace capcon
