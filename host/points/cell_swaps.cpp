#include "points/cell_swaps.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "points/checks.h"

namespace capcon {
namespace {

template <EnsembleDomain domain>
class Pair {
 public:
  Pair(const std::vector<glm::vec3>& centres, std::uint32_t* a, std::uint32_t* b, std::uint32_t n)
      : cells_{a, b}, n_(n), m_(2 * n), distance_(std::size_t(m_) * m_), gain_(m_), inside_(m_), lead_(m_) {
    const SpreadWeights weights = spread_weights(n);
    std::vector<float> x(m_), y(m_), z(m_);
    for (std::uint32_t i = 0; i < m_; ++i) {
      const glm::vec3 c = centres[i < n ? a[i] : b[i - n]];
      x[i] = c.x, y[i] = c.y, z[i] = c.z;
      inside_[i] = i < n ? kNever : 0.0f;
    }
    for (std::uint32_t i = 0; i < m_; ++i) {
      float* row = &distance_[std::size_t(i) * m_];
      for (std::uint32_t j = 0; j < m_; ++j)
        row[j] = spread_distance<domain>(x[i] - x[j], y[i] - y[j], z[i] - z[j], weights);
      const float sign = i < n ? 1.0f : -1.0f;
      for (std::uint32_t j = 0; j < m_; ++j) lead_[j] += sign * row[j];
    }
  }

  bool run() {
    std::vector<std::uint32_t> place(n_);
    for (std::uint32_t i = 0; i < n_; ++i) place[i] = i;
    bool any = true, ever = false;
    for (int pass = 0; any && pass < 3; ++pass) {
      any = false;
      for (std::uint32_t& p : place) any = best_swap(p) || any;
      ever = ever || any;
    }
    if (!ever) return false;
    std::vector<std::uint32_t> all(cells_[0], cells_[0] + n_);
    all.insert(all.end(), cells_[1], cells_[1] + n_);
    if constexpr (kChecks)
      require(std::count(inside_.begin(), inside_.end(), kNever) == n_,
              "cell swaps: a set has not its number of cells");
    std::uint32_t *a = cells_[0], *b = cells_[1];
    for (std::uint32_t i = 0; i < m_; ++i) (inside_[i] < 0 ? *a++ : *b++) = all[i];
    return true;
  }

 private:
  static constexpr float kNever = -1e9f;
  // Below this it may be rounding, and a tie could swap for ever but for the passes, which are three.
  static constexpr float kLeastGain = 1e-4f;
  static constexpr std::uint32_t kLanes = 8;

  /// The swap of point p of the first set with the one of the second that gains most; p is then that one.
  bool best_swap(std::uint32_t& p) {
    const float* row = &distance_[std::size_t(p) * m_];
    float most[kLanes];
    std::fill(most, most + kLanes, kNever);
    for (std::uint32_t j = 0; j < m_; ++j) gain_[j] = lead_[j] - 2 * row[j] + inside_[j];
    std::uint32_t j = 0;
    for (; j + kLanes <= m_; j += kLanes)
      for (std::uint32_t k = 0; k < kLanes; ++k) most[k] = std::max(most[k], gain_[j + k]);
    float best = *std::max_element(most, most + kLanes);
    for (; j < m_; ++j) best = std::max(best, gain_[j]);
    if (best - lead_[p] <= kLeastGain) return false;
    const auto q = static_cast<std::uint32_t>(std::find(gain_.begin(), gain_.end(), best) - gain_.begin());
    const float* other = &distance_[std::size_t(q) * m_];
    if constexpr (kChecks) check_swap(p, q, best - lead_[p]);
    for (std::uint32_t k = 0; k < m_; ++k) lead_[k] += 2 * (other[k] - row[k]);
    std::swap(inside_[p], inside_[q]);
    p = q;
    return true;
  }

  /// The gain anew, in double, from the distances alone. What `gain` may be wrong by: both leads are sums of
  /// m_ floats, changed twice at each swap, every one rounded at 2^-24 of a sum that no partial sum exceeds.
  void check_swap(std::uint32_t p, std::uint32_t q, float gain) {
    require(inside_[p] == kNever && inside_[q] == 0, "cell swaps: a swap within a set");
    double within = 0, fresh = -2.0 * distance_[std::size_t(p) * m_ + q], longest = 0;
    for (std::uint32_t k = 0; k < m_; ++k) {
      const double to_p = distance_[std::size_t(p) * m_ + k], to_q = distance_[std::size_t(q) * m_ + k];
      fresh += inside_[k] < 0 ? to_q - to_p : to_p - to_q;
      within += inside_[k] < 0 ? to_p : to_q;
      longest = std::max({longest, to_p, to_q});
    }
    const double rounding = 2 * 0x1p-24 * (m_ + 4.0 * swaps_++ + 4) * n_ * longest;
    require(std::abs(gain - fresh) <= rounding, "cell swaps: a gain is wrong by more than rounding");
    constexpr double kPromised =
        1e-4;  // of gain, as computed: said again, so that a change there is seen here
    check_step(Checked::kCells, -fresh, std::max(0.0, rounding - kPromised), within);
  }

  std::uint64_t swaps_ = 0;  ///< counted by checks only
  std::uint32_t* cells_[2];
  std::uint32_t n_, m_;
  std::vector<float> distance_;
  std::vector<float> gain_;
  std::vector<float> inside_;  ///< kNever for points of the first set, 0 for those of the second
  std::vector<float> lead_;    ///< the sum of a point's distances to the first set less that to the second
};

}  // namespace

bool swap_cells(EnsembleDomain domain, const std::vector<glm::vec3>& centres, std::uint32_t* a,
                std::uint32_t* b, std::uint32_t n) {
  switch (domain) {
    case EnsembleDomain::square:
      return Pair<EnsembleDomain::square>(centres, a, b, n).run();
    case EnsembleDomain::disk:
      return Pair<EnsembleDomain::disk>(centres, a, b, n).run();
    case EnsembleDomain::cylinder:
      break;
  }
  return Pair<EnsembleDomain::cylinder>(centres, a, b, n).run();
}

}  // namespace capcon
