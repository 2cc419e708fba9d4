#include "points/ranked_order.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/vec3.hpp>
#include <numeric>
#include <utility>
#include <vector>

#include "base/hash.h"
#include "base/parallel.h"
#include "points/cell_swaps.h"
#include "points/halved_order.h"

namespace capcon {
namespace {

constexpr std::uint64_t kClassStream = 0x72616e6b;
constexpr int kSweeps = 20;

/// One set, while it is put in order.
template <EnsembleDomain domain>
class Ranking {
 public:
  Ranking(const Ensemble& e, std::uint32_t* cells, std::uint32_t n)
      : columns_(e.columns),
        rows_(e.rows),
        cells_(cells),
        n_(n),
        bits_((31 - static_cast<std::uint32_t>(std::countl_zero(n))) / 2),
        q_(1u << bits_),
        m_(n / q_),
        distance_(std::size_t(n) * n),
        weight_(std::size_t(m_) * m_),
        within_(std::size_t(q_) * q_),
        to_class_(std::size_t(n) * m_) {}

  void run(std::uint64_t set) {
    halve_in_turn(cells_, n_, columns_, bits_);  // into regions, each of m_ cells that follow each other
    deal(set);
    measure();
    for (int sweep = 0; sweep < kSweeps && improve(); ++sweep) {
    }
    write();
  }

 private:
  glm::dvec2 centre(std::uint32_t cell) const {
    return {(cell % columns_ + 0.5) / columns_, (cell / columns_ + 0.5) / rows_};
  }

  /// at_[r * m_ + c]: the point, by number, of class c in region r.
  void deal(std::uint64_t set) {
    at_.resize(n_);
    for (std::uint32_t r = 0; r < q_; ++r) {
      std::uint32_t* const region = &at_[r * m_];
      std::iota(region, region + m_, r * m_);
      for (std::uint32_t k = m_; k > 1; --k)
        std::swap(region[k - 1], region[mix64(set, kClassStream + r, k) % k]);
    }
  }

  void measure() {
    std::vector<glm::vec3> place(n_);
    for (std::uint32_t i = 0; i < n_; ++i) place[i] = spread_place(domain, centre(cells_[i]));
    const SpreadWeights weights = spread_weights(n_);
    for (std::uint32_t i = 0; i < n_; ++i) {
      for (std::uint32_t j = 0; j < n_; ++j) {
        const glm::vec3 d = place[i] - place[j];
        distance_[i * n_ + j] = spread_distance<domain>(d.x, d.y, d.z, weights);
      }
    }
    // A block of 2^k cells has that share of them, its spread counts by n^-2, and the least of it falls like
    // n^-1.5: 2^(k / 2) for pairs within such blocks.
    const auto weight = [](std::uint32_t k) { return std::exp2(0.5f * static_cast<float>(k)); };
    for (std::uint32_t a = 0; a < m_; ++a)
      for (std::uint32_t b = 0; b < m_; ++b)
        for (std::uint32_t k = 0; (1u << k) < m_; ++k)
          weight_[a * m_ + b] += (a >> k) == (b >> k) ? weight(bits_ + k) : 0.0f;
    for (std::uint32_t t = 0; t < q_; ++t)
      for (std::uint32_t u = 0; u < q_; ++u)
        for (std::uint32_t k = 1; k < bits_; ++k)
          if (t >> k == u >> k) within_[ranked_region(t, bits_) * q_ + ranked_region(u, bits_)] += weight(k);
    for (std::uint32_t c = 0; c < m_; ++c)
      for (std::uint32_t r = 0; r < q_; ++r) add(at_[r * m_ + c], c, 1);
  }

  /// to_class_[i * m_ + c]: sum of the distances of point i to those of class c.
  void add(std::uint32_t point, std::uint32_t to, float sign) {
    for (std::uint32_t i = 0; i < n_; ++i) to_class_[i * m_ + to] += sign * distance_[point * n_ + i];
  }

  /// By how much the weighted sum grows if points i of class a and j of class b change places.
  float gain(std::uint32_t r, std::uint32_t a, std::uint32_t b) const {
    const std::uint32_t i = at_[r * m_ + a], j = at_[r * m_ + b];
    float sum = 0;
    for (std::uint32_t s = 0; s < q_; ++s) {
      if (s == r || within_[r * q_ + s] == 0) continue;
      const float *of_a = &distance_[at_[s * m_ + a] * n_], *of_b = &distance_[at_[s * m_ + b] * n_];
      sum += within_[r * q_ + s] * (of_a[j] - of_a[i] + of_b[i] - of_b[j]);
    }
    const float *of_i = &to_class_[i * m_], *of_j = &to_class_[j * m_], *at_a = &weight_[a * m_],
                *at_b = &weight_[b * m_];
    for (std::uint32_t c = 0; c < m_; ++c) sum += (at_a[c] - at_b[c]) * (of_j[c] - of_i[c]);
    // Their own distance, which stays as it is, was in it twice.
    return sum - distance_[i * n_ + j] * (at_a[a] + at_b[b] - 2 * at_a[b]);
  }

  bool improve() {
    bool any = false;
    for (std::uint32_t r = 0; r < q_; ++r) {
      for (std::uint32_t a = 0; a < m_; ++a) {
        for (std::uint32_t b = a + 1; b < m_; ++b) {
          std::uint32_t &i = at_[r * m_ + a], &j = at_[r * m_ + b];
          if (gain(r, a, b) <= 1e-4f) continue;
          add(i, a, -1), add(j, b, -1), add(i, b, 1), add(j, a, 1);
          std::swap(i, j);
          any = true;
        }
      }
    }
    return any;
  }

  void write() {
    std::vector<std::uint32_t> ranked(n_);
    for (std::uint32_t t = 0; t < q_; ++t)
      for (std::uint32_t c = 0; c < m_; ++c)
        ranked[c * q_ + t] = cells_[at_[ranked_region(t, bits_) * m_ + c]];
    std::copy(ranked.begin(), ranked.end(), cells_);
  }

  std::uint32_t columns_, rows_;
  std::uint32_t* cells_;
  std::uint32_t n_, bits_, q_, m_;
  std::vector<float> distance_;
  std::vector<float> weight_;  ///< of pairs of classes, [a * m_ + b]
  std::vector<float> within_;  ///< of pairs of regions in one class, beside that, [r * q_ + s]
  std::vector<float> to_class_;
  std::vector<std::uint32_t> at_;
};

}  // namespace

void rank_cells(Ensemble& e, EnsembleDomain domain) {
  const auto n = static_cast<std::uint32_t>(e.cells.size() / e.sets);
  parallel_for(e.sets, [&](std::size_t s) {
    std::uint32_t* const cells = &e.cells[s * n];
    if (domain == EnsembleDomain::square) Ranking<EnsembleDomain::square>(e, cells, n).run(s);
    if (domain == EnsembleDomain::disk) Ranking<EnsembleDomain::disk>(e, cells, n).run(s);
    if (domain == EnsembleDomain::cylinder) Ranking<EnsembleDomain::cylinder>(e, cells, n).run(s);
  });
}

}  // namespace capcon
