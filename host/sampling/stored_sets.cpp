#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"
#include "layout.h"
#include "points/import_points.h"
#include "sampling/address.h"
#include "sampling/bits.h"
#include "sampling/point_file.h"
#include "sampling/rotated_set.h"

namespace capcon {
namespace {

using Randomisation = PointFile::Randomisation;

constexpr std::size_t kMostPoints = std::size_t(1) << 24;  // a table of 256 MiB

/// Sets of a user's, one of them chosen for a (pixel, dimension pair) and randomised there.
class StoredSetsSampler final : public Sampler {
 public:
  /// `sets` have as many points each.
  StoredSetsSampler(std::string name, const std::vector<Points>& sets, Randomisation randomisation,
                    std::uint32_t seed, std::uint32_t parts)
      : Sampler(std::move(name), static_cast<std::uint32_t>(sets.front().size()), seed, parts),
        sets_(static_cast<std::uint32_t>(sets.size())),
        randomisation_(randomisation) {
    points_.reserve(std::size_t(sets_) * count());
    for (const Points& set : sets) {
      for (const glm::dvec2 p : set) points_.push_back(to_fixed(p));
    }
  }

  FixedPoint point(std::uint32_t pixel, std::uint32_t index, std::uint32_t dimension,
                   SampleDomain) const override {
    const auto words = set_words(seed(), pixel, dimension);
    const FixedPoint p = points_[(std::uint64_t(words[3]) * sets_ >> 32) * count() + index];
    if (randomisation_ == Randomisation::none) return p;
    if (randomisation_ == Randomisation::xor_digits) return {p.x ^ words[0], p.y ^ words[1]};
    return {p.x + words[0], p.y + words[1]};
  }

  /// As pmj02's sequences under xor, else as ccvt's set: tables, whatever made them.
  SamplerTables tables(const std::vector<SampleDomain>&) const override {
    if (randomisation_ == Randomisation::xor_digits) {
      SamplerTables result{layout::kSamplerPmj02, {sets_, 0, 0, 0}, {}};
      for (std::size_t i = 0; i < points_.size(); i += 2) {
        const FixedPoint a = points_[i], b = points_[std::min(i + 1, points_.size() - 1)];
        result.texels.emplace_back(a.x, a.y, b.x, b.y);
      }
      return result;
    }
    const std::uint32_t still = randomisation_ == Randomisation::none ? 1 : 0;
    SamplerTables result{layout::kSamplerCcvt, {sets_, still, 0, 0}, {}};
    for (const FixedPoint p : points_) result.texels.emplace_back(p.x, p.y, 0, 0);
    return result;
  }

 protected:
  bool is_stored_by_place() const override { return randomisation_ != Randomisation::xor_digits; }

 private:
  std::uint32_t sets_;
  Randomisation randomisation_;
  std::vector<FixedPoint> points_;
};

std::string path_for(std::string path, std::uint32_t count) {
  const std::size_t at = path.find("{n}");
  return at == path.npos ? path : path.replace(at, 3, std::to_string(count));
}

/// The sets of `count` points, else the beginnings of longer ones; `longer` says which.
std::vector<Points> sets_for(const std::string& path, std::uint32_t count, bool& longer) {
  std::vector<Points> sets = import_points(path);
  std::size_t largest = 0;
  for (const Points& set : sets) largest = std::max(largest, set.size());
  if (largest < count) {
    throw InputError(
        fmt::format("{}: {} points are asked for, and its largest set has {}; ask for fewer, or "
                    "bring a set of as many or more",
                    path, count, largest));
  }
  longer = std::none_of(sets.begin(), sets.end(), [&](const Points& set) { return set.size() == count; });
  std::erase_if(sets, [&](const Points& set) { return longer ? set.size() < count : set.size() != count; });
  for (Points& set : sets) set.resize(count);
  if (sets.size() * count > kMostPoints) {
    throw InputError(
        fmt::format("{}: {} sets of {} points are more than the {} points that are kept; bring "
                    "fewer sets",
                    path, sets.size(), count, kMostPoints));
  }
  return sets;
}

}  // namespace

std::unique_ptr<Sampler> make_point_file_sampler(std::string_view sampler, std::uint32_t count,
                                                 std::uint32_t seed, std::uint32_t parts) {
  const PointFile file = parse_point_file(sampler);
  const std::string path = path_for(file.path, count);
  bool longer = false;
  std::vector<Points> sets = sets_for(path, count, longer);
  if (file.randomisation == Randomisation::none && sets.size() < 2) {
    throw InputError(
        fmt::format("{}: with :none every pixel would have the same points, as it holds one set "
                    "of {}; bring several, or leave out :none",
                    path, count));
  }
  const bool ordered = longer || file.sequence || file.randomisation == Randomisation::xor_digits;
  if (parts > 1 && !ordered)
    parallel_for(sets.size(), [&](std::size_t i) { sets[i] = part_by_part(sets[i], parts); });
  return std::make_unique<StoredSetsSampler>(sampler_label(sampler), sets, file.randomisation, seed, parts);
}

}  // namespace capcon
