#include "points/near_swaps.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/hash.h"
#include "base/parallel.h"
#include "points/cell_swaps.h"
#include "points/checks.h"

namespace capcon {
namespace {

constexpr std::uint64_t kPairStream = 0x6e656172;
// Below this it may be rounding, and a tie could swap for ever but for the passes and rounds, which are
// counted.
constexpr float kLeastGain = 1e-4f;
constexpr SpreadWeights kLargeSets;  // those of many points
constexpr int kPasses = 2;
// Partners are looked for in the bins within kReach of a cell's own, which hold about kInBin cells of each
// set: a hundred at most.
constexpr std::uint32_t kInBin = 4;
constexpr int kReach = 2;

template <EnsembleDomain domain>
struct Cells {
  std::vector<float> x, y, z;
  void add(glm::vec3 c) {
    x.push_back(c.x);
    y.push_back(c.y);
    z.push_back(c.z);
  }
  std::size_t size() const { return x.size(); }
  float distance(std::size_t i, std::size_t j) const {
    return spread_distance<domain>(x[i] - x[j], y[i] - y[j], z[i] - z[j], kLargeSets);
  }
};

/// Adds to rows[i] the sum of distances from cell i of `a` to all of `b`, and to columns[j] the other way
/// round. Sums are of 64 floats at most, then of doubles: gains are far smaller than they.
template <EnsembleDomain domain>
void add_distances(const Cells<domain>& a, const Cells<domain>& b, double* rows, double* columns) {
  constexpr std::size_t kBlock = 64;
  std::vector<float> column(b.size());
  for (std::size_t first = 0; first < a.size(); first += kBlock) {
    std::fill(column.begin(), column.end(), 0.0f);
    for (std::size_t i = first; i < std::min(a.size(), first + kBlock); ++i) {
      const float x = a.x[i], y = a.y[i], z = a.z[i];
      double row = 0;
      for (std::size_t from = 0; from < b.size(); from += kBlock) {
        const std::size_t length = std::min(kBlock, b.size() - from);
        float d[kBlock];
        for (std::size_t k = 0; k < length; ++k) {
          d[k] = spread_distance<domain>(x - b.x[from + k], y - b.y[from + k], z - b.z[from + k], kLargeSets);
          column[from + k] += d[k];
        }
        float lanes[8] = {};
        std::size_t k = 0;
        for (; k + 8 <= length; k += 8)
          for (std::size_t l = 0; l < 8; ++l) lanes[l] += d[k + l];
        for (; k < length; ++k) lanes[0] += d[k];
        for (const float lane : lanes) row += lane;
      }
      rows[i] += row;
    }
    for (std::size_t j = 0; j < b.size(); ++j) columns[j] += column[j];
  }
}

template <EnsembleDomain domain>
class NearSwaps {
 public:
  NearSwaps(Ensemble& e, const std::vector<glm::vec3>& centres)
      : e_(e), centres_(centres), n_(e.cells.size() / e.sets), own_(e.cells.size()) {
    side_ = std::max(1u, static_cast<std::uint32_t>(std::sqrt(double(n_) / kInBin)));
    parallel_for(e.sets, [&](std::size_t s) {
      const Cells<domain> cells = cells_of(s);
      std::vector<double> unused(n_);
      add_distances(cells, cells, &own_[s * n_], unused.data());
    });
  }

  void begin_round(std::uint32_t round) { round_ = round; }

  void meet(std::size_t a, std::size_t b) {
    Meeting m;
    for (const std::size_t s : {a, b}) {
      for (std::size_t i = s * n_; i < (s + 1) * n_; ++i) {
        m.cells.add(centres_[e_.cells[i]]);
        m.names.push_back(e_.cells[i]);
        m.sum.push_back(own_[i]);
      }
    }
    std::vector<double> across(2 * n_);
    add_distances(cells_of(a), cells_of(b), across.data(), across.data() + n_);
    for (std::size_t i = 0; i < 2 * n_; ++i) {
      m.lead.push_back(static_cast<float>(i < n_ ? m.sum[i] - across[i] : across[i] - m.sum[i]));
      m.sum[i] += across[i];
      m.first.push_back(i < n_ ? 1 : 0);
    }
    sort_into_bins(m);
    if (!swap_all(m)) return;
    std::size_t next[2] = {b * n_, a * n_};
    for (std::size_t i = 0; i < 2 * n_; ++i) {
      const std::size_t to = next[m.first[i] != 0 ? 1 : 0]++;
      e_.cells[to] = m.names[i];
      own_[to] = 0.5 * (m.sum[i] + (m.first[i] != 0 ? m.lead[i] : -m.lead[i]));
    }
    if constexpr (kChecks)
      require(next[0] == (b + 1) * n_ && next[1] == (a + 1) * n_,
              "near swaps: a set has not its number of cells");
  }

 private:
  /// Two sets' cells, those of the first first.
  struct Meeting {
    Cells<domain> cells;
    std::vector<std::uint32_t> names;
    std::vector<double> sum;                      ///< of distances to the cells of both sets
    std::vector<float> lead;                      ///< to those of the first less those of the second
    std::vector<char> first;                      ///< whether the cell is the first set's
    std::vector<std::uint32_t> in_bin, bin_ends;  ///< the cells by bins, and where a bin ends
  };

  Cells<domain> cells_of(std::size_t set) const {
    Cells<domain> cells;
    for (std::size_t i = set * n_; i < (set + 1) * n_; ++i) cells.add(centres_[e_.cells[i]]);
    return cells;
  }

  glm::ivec2 bin_of(std::uint32_t cell) const {
    return {int(std::uint64_t(cell % e_.columns) * side_ / e_.columns),
            int(std::uint64_t(cell / e_.columns) * side_ / e_.rows)};
  }

  void sort_into_bins(Meeting& m) const {
    m.bin_ends.assign(std::size_t(side_) * side_ + 1, 0);
    const auto bin = [&](std::size_t i) {
      const glm::ivec2 at = bin_of(m.names[i]);
      return std::size_t(at.y) * side_ + at.x;
    };
    for (std::size_t i = 0; i < m.names.size(); ++i) ++m.bin_ends[bin(i) + 1];
    std::partial_sum(m.bin_ends.begin(), m.bin_ends.end(), m.bin_ends.begin());
    std::vector<std::uint32_t> next = m.bin_ends;
    m.in_bin.resize(m.names.size());
    for (std::uint32_t i = 0; i < m.names.size(); ++i) m.in_bin[next[bin(i)]++] = i;
  }

  bool swap_all(Meeting& m) const {
    std::vector<std::uint32_t> place(n_);
    std::iota(place.begin(), place.end(), 0u);
    bool any = true, ever = false;
    for (int pass = 0; any && pass < kPasses; ++pass) {
      any = false;
      for (std::uint32_t& p : place) any = best_swap(m, p) || any;
      ever = ever || any;
    }
    return ever;
  }

  /// The swap of cell p of the first set with the one of the second near it that gains most; p is then that
  /// one.
  bool best_swap(Meeting& m, std::uint32_t& p) const {
    const glm::ivec2 at = bin_of(m.names[p]);
    const int side = int(side_), reach = std::min(kReach, (side - 1) / 2);
    float most = kLeastGain;
    std::uint32_t q = p;
    for (int y = std::max(0, at.y - reach); y <= std::min(side - 1, at.y + reach); ++y) {
      for (int dx = -reach; dx <= reach; ++dx) {
        // Around the cylinder; in other domains cells of the other side are too far to gain.
        const int x = (at.x + dx + side) % side;
        const std::size_t bin = std::size_t(y) * side_ + std::size_t(x);
        for (std::uint32_t k = m.bin_ends[bin]; k < m.bin_ends[bin + 1]; ++k) {
          const std::uint32_t i = m.in_bin[k];
          if (m.first[i] != 0) continue;
          const float gain = m.lead[i] - m.lead[p] - 2 * m.cells.distance(p, i);
          if (gain > most) most = gain, q = i;
        }
      }
    }
    if (q == p) return false;
    if constexpr (kChecks) check_swap(m, p, q, most);
    const Cells<domain>& c = m.cells;
    const float px = c.x[p], py = c.y[p], pz = c.z[p], qx = c.x[q], qy = c.y[q], qz = c.z[q];
    for (std::size_t k = 0; k < c.size(); ++k) {
      m.lead[k] += 2 * (spread_distance<domain>(c.x[k] - qx, c.y[k] - qy, c.z[k] - qz, kLargeSets) -
                        spread_distance<domain>(c.x[k] - px, c.y[k] - py, c.z[k] - pz, kLargeSets));
    }
    std::swap(m.first[p], m.first[q]);
    p = q;
    return true;
  }

  /// The gain anew, in double, from the distances alone. `gain` may be wrong by the rounding of both leads,
  /// which were summed in runs of 64 floats and have been changed twice at each swap of this round and of
  /// those before.
  void check_swap(const Meeting& m, std::uint32_t p, std::uint32_t q, float gain) const {
    require(m.first[p] != 0 && m.first[q] == 0, "near swaps: a swap within a set");
    double within = 0, fresh = -2.0 * m.cells.distance(p, q), longest = 0;
    for (std::size_t k = 0; k < m.names.size(); ++k) {
      const double to_p = m.cells.distance(p, k), to_q = m.cells.distance(q, k);
      fresh += m.first[k] != 0 ? to_q - to_p : to_p - to_q;
      within += m.first[k] != 0 ? to_p : to_q;
      longest = std::max({longest, to_p, to_q});
    }
    const double changes = 4.0 * kPasses * double(n_) * (round_ + 1);
    const double rounding = 2 * 0x1p-24 * (64 + changes) * double(n_) * longest;
    require(std::abs(gain - fresh) <= rounding, "near swaps: a gain is wrong by more than rounding");
    constexpr double kPromised =
        1e-4;  // of gain, as computed: said again, so that a change there is seen here
    check_step(Checked::kNear, -fresh, std::max(0.0, rounding - kPromised), within);
  }

  Ensemble& e_;
  const std::vector<glm::vec3>& centres_;
  std::size_t n_;
  std::uint32_t round_ = 0;
  std::uint32_t side_ = 1;   ///< of the grid of bins
  std::vector<double> own_;  ///< [set * n + i]: the sum of distances from cell i to its set's cells
};

template <EnsembleDomain domain>
void swap_in(Ensemble& e, const std::vector<glm::vec3>& centres, std::uint32_t rounds, std::uint64_t seed) {
  NearSwaps<domain> swaps(e, centres);
  std::vector<std::uint32_t> order(e.sets);
  for (std::uint32_t round = 0; round < rounds; ++round) {
    swaps.begin_round(round);
    std::iota(order.begin(), order.end(), 0u);
    for (std::size_t i = order.size(); i > 1; --i)
      std::swap(order[i - 1], order[mix64(seed, kPairStream + round, i) % i]);
    parallel_for(e.sets / 2, [&](std::size_t k) { swaps.meet(order[2 * k], order[2 * k + 1]); });
  }
}

}  // namespace

void swap_near(Ensemble& e, EnsembleDomain domain, const std::vector<glm::vec3>& centres,
               std::uint32_t rounds, std::uint64_t seed) {
  switch (domain) {
    case EnsembleDomain::square:
      return swap_in<EnsembleDomain::square>(e, centres, rounds, seed);
    case EnsembleDomain::disk:
      return swap_in<EnsembleDomain::disk>(e, centres, rounds, seed);
    case EnsembleDomain::cylinder:
      return swap_in<EnsembleDomain::cylinder>(e, centres, rounds, seed);
  }
}

}  // namespace capcon
