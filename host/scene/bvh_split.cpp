#include "scene/bvh_split.h"

#include <array>
#include <vector>

#include "base/parallel.h"

namespace capcon {
namespace {

constexpr int kBins = 32;   // at most
constexpr int kFewest = 4;  // of small nodes: most nodes are small, and their bins mostly empty

/// As many bins as references, within these bounds.
int bins_for(std::size_t count) {
  return static_cast<int>(std::clamp<std::size_t>(count, kFewest, kBins));
}

/// What falls into one bin: boxes, and how many references begin and end there.
struct Bin {
  FloatBox box;
  std::uint32_t begins = 0, ends = 0;
};

using Bins = std::array<Bin, kBins>;

void merge(Bins& into, const Bins& from) {
  for (int b = 0; b < kBins; ++b) {
    into[b].box.add(from[b].box);
    into[b].begins += from[b].begins;
    into[b].ends += from[b].ends;
  }
}

/// Sums of references, by `add(sum, reference)`: of many in parts, on all threads. Parts do not depend on the
/// number of threads, nor does a minimum, a maximum or a count on parts.
template <class Sum, class Add, class Merge>
Sum sum_of(std::span<const Reference> references, const Add& add, const Merge& merge) {
  constexpr std::size_t kMany = 1 << 18, kPart = 1 << 15;
  Sum whole;
  if (references.size() < kMany) {
    for (const Reference& r : references) add(whole, r);
    return whole;
  }
  std::vector<Sum> sums((references.size() + kPart - 1) / kPart);
  parallel_for(sums.size(), [&](std::size_t k) {
    Sum sum;  // its own memory, not beside another thread's
    for (const Reference& r : references.subspan(k * kPart, std::min(kPart, references.size() - k * kPart)))
      add(sum, r);
    sums[k] = sum;
  });
  for (const Sum& sum : sums) merge(whole, sum);
  return whole;
}

/// The cheapest of the planes between bins. `plane(i)`: where bin i begins.
template <class Plane>
void sweep(const Bins& bins, int bin_count, int axis, std::size_t count, std::size_t spare,
           const Plane& plane, Split& best) {
  std::array<FloatBox, kBins> right;
  FloatBox box;
  for (int b = bin_count - 1; b > 0; --b) {
    box.add(bins[b].box);
    right[b] = box;
  }
  FloatBox left;
  std::size_t left_count = 0, right_count = count;
  for (int b = 0; b + 1 < bin_count; ++b) {
    left.add(bins[b].box);
    left_count += bins[b].begins;
    right_count -= bins[b].ends;
    if (left_count == 0 || right_count == 0 || left_count + right_count > count + spare) continue;
    const double cost = left.half_area() * static_cast<double>(left_count) +
                        right[b + 1].half_area() * static_cast<double>(right_count);
    if (cost >= best.cost) continue;
    best.axis = axis;
    best.plane = plane(b + 1);
    best.left = left;
    best.right = right[b + 1];
    best.left_count = static_cast<std::uint32_t>(left_count);
    best.right_count = static_cast<std::uint32_t>(right_count);
    best.cost = cost;
  }
}

}  // namespace

Bounds bounds_of(std::span<const Reference> references) {
  return sum_of<Bounds>(
      references,
      [](Bounds& sum, const Reference& r) {
        sum.box.add(r);
        const float c[3] = {r.centre(0), r.centre(1), r.centre(2)};
        for (int a = 0; a < 3; ++a) {
          sum.centres.low[a] = std::min(sum.centres.low[a], c[a]);
          sum.centres.high[a] = std::max(sum.centres.high[a], c[a]);
        }
      },
      [](Bounds& sum, const Bounds& part) {
        sum.box.add(part.box);
        sum.centres.add(part.centres);
      });
}

Split best_object_split(std::span<const Reference> references, const FloatBox& centres) {
  const int count = bins_for(2 * references.size());
  std::array<CentreBins, 3> axes;
  for (int a = 0; a < 3; ++a) {
    const float width = (centres.high[a] - centres.low[a]) / static_cast<float>(count);
    const bool usable = width > 0 && 1 / width < 3e38f;
    axes[a] = {centres.low[a], usable ? 1 / width : 0, count};
  }
  auto bins = sum_of<std::array<Bins, 3>>(
      references,
      [&](std::array<Bins, 3>& sum, const Reference& r) {
        for (int a = 0; a < 3; ++a) {
          Bin& bin = sum[a][axes[a].of(r.centre(a))];
          bin.box.add(r);
          ++bin.begins;
        }
      },
      [](std::array<Bins, 3>& sum, const std::array<Bins, 3>& part) {
        for (int a = 0; a < 3; ++a) merge(sum[a], part[a]);
      });
  Split best;
  for (int a = 0; a < 3; ++a) {
    if (!(axes[a].scale > 0)) continue;
    for (int b = 0; b < count; ++b) bins[a][b].ends = bins[a][b].begins;
    const double before = best.cost;
    sweep(
        bins[a], count, a, references.size(), 0, [](int b) { return static_cast<float>(b); }, best);
    if (best.cost < before) {
      best.bin = static_cast<int>(best.plane);
      best.bins = axes[a];
    }
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
    struct Sum {
      Bins bins;
      std::array<FloatBox, kBins> parts;
    };
    Sum sum = sum_of<Sum>(
        references,
        [&](Sum& s, const Reference& r) {
          const int first = bin_of(r.low[axis]), last = std::max(first, bin_of(r.high[axis]));
          ++s.bins[first].begins;
          ++s.bins[last].ends;
          if (first == last) {
            s.bins[first].box.add(r);
          } else {
            cutter.add_parts(r, axis, first, last, plane, s.parts.data());
          }
        },
        [](Sum& s, const Sum& part) {
          merge(s.bins, part.bins);
          for (int b = 0; b < kBins; ++b) s.parts[b].add(part.parts[b]);
        });
    for (int b = 0; b < kBins; ++b) sum.bins[b].box.add(sum.parts[b]);
    sweep(sum.bins, kBins, axis, references.size(), spare, plane, best);
  }
  return best;
}

}  // namespace capcon
