#include "scene/bvh_split.h"

#include <array>

namespace capcon {
namespace {

constexpr int kBins = 32;

/// What falls into one bin: boxes, and how many references begin and end there.
struct Bin {
  FloatBox box;
  std::uint32_t begins = 0, ends = 0;
};

using Bins = std::array<Bin, kBins>;

/// The cheapest of the planes between bins. `plane(i)`: where bin i begins.
template <class Plane>
void sweep(const Bins& bins, int axis, std::size_t count, std::size_t spare, const Plane& plane,
           Split& best) {
  std::array<FloatBox, kBins> right;
  FloatBox box;
  for (int b = kBins - 1; b > 0; --b) {
    box.add(bins[b].box);
    right[b] = box;
  }
  FloatBox left;
  std::size_t left_count = 0, right_count = count;
  for (int b = 0; b + 1 < kBins; ++b) {
    left.add(bins[b].box);
    left_count += bins[b].begins;
    right_count -= bins[b].ends;
    if (left_count == 0 || right_count == 0 || left_count + right_count > count + spare) continue;
    const double cost = left.half_area() * static_cast<double>(left_count) +
                        right[b + 1].half_area() * static_cast<double>(right_count);
    if (cost >= best.cost) continue;
    best = {axis,
            plane(b + 1),
            left,
            right[b + 1],
            static_cast<std::uint32_t>(left_count),
            static_cast<std::uint32_t>(right_count),
            cost};
  }
}

}  // namespace

Split best_object_split(std::span<const Reference> references, const FloatBox& centres) {
  Split best;
  for (int axis = 0; axis < 3; ++axis) {
    const float low = centres.low[axis], width = (centres.high[axis] - low) / kBins;
    if (!(width > 0) || !(1 / width < 3e38f)) continue;
    // Bins by comparison with the very planes that divide later, so that counts are what they will be.
    const auto plane = [&](int b) { return low + width * static_cast<float>(b); };
    const float scale = 1 / width;
    Bins bins;
    for (const Reference& r : references) {
      const float c = r.centre(axis);
      int b = std::clamp(static_cast<int>((c - low) * scale), 0, kBins - 1);
      while (b > 0 && c < plane(b)) --b;
      while (b + 1 < kBins && c >= plane(b + 1)) ++b;
      bins[b].box.add(r);
      ++bins[b].begins;
      ++bins[b].ends;
    }
    sweep(bins, axis, references.size(), 0, plane, best);
  }
  return best;
}

Split best_spatial_split(std::span<const Reference> references, const FloatBox& box, std::size_t spare,
                         const Cutter& cutter) {
  Split best;
  for (int axis = 0; axis < 3; ++axis) {
    const float low = box.low[axis], high = box.high[axis], width = (high - low) / kBins;
    if (!(width > 0) || low + width == low || high - width == high || !(1 / width < 3e38f)) continue;
    const auto plane = [&](int b) { return b == kBins ? high : low + width * static_cast<float>(b); };
    const auto bin_of = [&](float at) {
      return std::clamp(static_cast<int>((at - low) / width), 0, kBins - 1);
    };
    Bins bins;
    std::array<FloatBox, kBins> parts;
    for (const Reference& r : references) {
      const int first = bin_of(r.low[axis]), last = std::max(first, bin_of(r.high[axis]));
      ++bins[first].begins;
      ++bins[last].ends;
      if (first == last) {
        bins[first].box.add(r);
      } else {
        cutter.add_parts(r, axis, first, last, plane, parts.data());
      }
    }
    for (int b = 0; b < kBins; ++b) bins[b].box.add(parts[b]);
    sweep(bins, axis, references.size(), spare, plane, best);
  }
  return best;
}

}  // namespace capcon
