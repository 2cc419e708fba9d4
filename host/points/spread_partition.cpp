#include "points/spread_partition.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.h"
#include "base/hash.h"
#include "base/morton.h"

namespace capcon {
namespace {

constexpr std::size_t kManyTries = 128;  // points at most
constexpr std::uint64_t kTries = 8;
constexpr double kMostBytes = 64 << 20;
constexpr std::uint64_t kDealStream = 0x73707264;

/// What partition keeps: 8 k neighbours a point and two distances a point and subset.
double table_bytes(double points, double subsets) {
  return points * (16 * std::min(points, 8 * subsets) + 24 * subsets);
}

std::vector<std::uint32_t> deal_along_curve(const Points& points, const PartitionOptions& options) {
  const std::uint32_t k = options.subsets;
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto code = [&](std::uint32_t i) {
    return morton_code(static_cast<std::uint32_t>(points[i].x * 0x1p32),
                       static_cast<std::uint32_t>(points[i].y * 0x1p32));
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return code(a) < code(b); });
  std::vector<std::uint32_t> labels(points.size()), deal(k);
  for (std::size_t first = 0; first < order.size(); first += k) {
    std::iota(deal.begin(), deal.end(), 0u);
    const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(k, order.size() - first));
    // The last, shorter block goes to the first labels: subsets differ by one at most.
    for (std::uint32_t i = count; i > 1; --i)
      std::swap(deal[i - 1], deal[mix64(options.seed, kDealStream, first + i) % i]);
    for (std::uint32_t i = 0; i < count; ++i) labels[order[first + i]] = deal[i];
  }
  return labels;
}

}  // namespace

SubsetSpacing subset_spacing(const Points& points, const std::vector<std::uint32_t>& labels,
                             std::uint32_t subsets) {
  SubsetSpacing result{0, 1e300};
  for (const Points& subset : split(points, labels, subsets)) {
    double sum = 0;
    for (std::size_t i = 0; i < subset.size(); ++i) {
      double least = 1;
      for (std::size_t j = 0; j < subset.size(); ++j) {
        const glm::dvec2 d = subset[i] - subset[j];
        if (i != j) least = std::min(least, std::hypot(std::remainder(d.x, 1.0), std::remainder(d.y, 1.0)));
      }
      sum += least;
    }
    const auto n = static_cast<double>(subset.size());
    const double spacing = subset.size() < 2 ? 1 : sum / n / std::sqrt(2 / (std::sqrt(3.0) * n));
    result.mean += spacing / subsets;
    result.worst = std::min(result.worst, spacing);
  }
  return result;
}

std::vector<std::uint32_t> spread_partition(const Points& points, const PartitionOptions& options) {
  const std::uint32_t k = options.subsets;
  if (k == points.size() && k > 0) {
    std::vector<std::uint32_t> each(k);
    std::iota(each.begin(), each.end(), 0u);
    return each;
  }
  const auto n = static_cast<double>(points.size());
  if (k > 1 && k < points.size() && table_bytes(n, k) > kMostBytes) return deal_along_curve(points, options);
  if (k <= 1 || points.size() > kManyTries) return partition(points, options);
  std::vector<std::uint32_t> best;
  double most = -1;
  for (std::uint64_t t = 0; t < kTries; ++t) {
    auto labels = partition(points, {k, mix64(options.seed, kDealStream + 1, t)});
    const SubsetSpacing spacing = subset_spacing(points, labels, k);
    if (spacing.mean + spacing.worst > most) {
      most = spacing.mean + spacing.worst;
      best = std::move(labels);
    }
  }
  return best;
}

}  // namespace capcon
