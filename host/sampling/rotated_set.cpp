#include "sampling/rotated_set.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/morton.h"
#include "layout.h"
#include "points/spread_partition.h"
#include "sampling/address.h"

namespace capcon {
namespace {

constexpr std::uint64_t kPartitionSeed = 1;

class RotatedSetSampler final : public Sampler {
 public:
  RotatedSetSampler(std::string name, const Points& points, std::uint32_t seed, std::uint32_t parts)
      : Sampler(std::move(name), static_cast<std::uint32_t>(points.size()), seed, parts) {
    for (const glm::dvec2 p : points) points_.push_back(to_fixed(p));
  }

  FixedPoint point(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension,
                   SampleDomain) const override {
    const auto words = set_words(seed(), pixel, dimension);
    return {points_[index].x + words[0], points_[index].y + words[1]};
  }

  /// The id is that of the first sampler that was made so; a set is a table, whatever made it.
  SamplerTables tables(const std::vector<SampleDomain>&) const override {
    SamplerTables result{layout::kSamplerCcvt, {0, 0, 0, 0}, {}};
    for (const FixedPoint p : points_) result.texels.emplace_back(p.x, p.y, 0, 0);
    return result;
  }

 protected:
  bool is_stored_by_place() const override { return true; }

 private:
  std::vector<FixedPoint> points_;
};

}  // namespace

Points part_by_part(const Points& points, std::uint32_t parts) {
  Points ordered;
  ordered.reserve(points.size());
  for (Points& part : split(points, spread_partition(points, {parts, kPartitionSeed}), parts)) {
    std::sort(part.begin(), part.end(), [](glm::dvec2 a, glm::dvec2 b) {
      const FixedPoint p = to_fixed(a), q = to_fixed(b);
      return morton_code(p.x, p.y) < morton_code(q.x, q.y);
    });
    ordered.insert(ordered.end(), part.begin(), part.end());
  }
  return ordered;
}

std::unique_ptr<Sampler> make_rotated_set_sampler(std::string name, const Points& points, std::uint32_t seed,
                                                  std::uint32_t parts) {
  return std::make_unique<RotatedSetSampler>(std::move(name), points, seed, parts);
}

}  // namespace capcon
