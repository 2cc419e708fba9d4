#include "points/ensemble.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

#include "base/error.h"
#include "base/hash.h"
#include "base/morton.h"
#include "base/parallel.h"
#include "points/cell_swaps.h"
#include "points/ensemble_start.h"
#include "points/near_swaps.h"

namespace capcon {
namespace {

constexpr std::uint64_t kOrderStream = 0x656e73656d, kPartStream = kOrderStream + 0x100000000;

// Beyond, whole sets' tables of distances leave the processor's caches.
constexpr std::uint32_t kMostWhole = 1024;

/// Finer cells for small sets, whose errors they are a larger part of: their tables stay small.
std::uint32_t wished_sets(const EnsembleOptions& options) {
  if (options.sets > 0) return options.sets;
  if (options.points > kMostWhole) return 65536 / options.points;
  return std::clamp(4096 / options.points, 64u, 256u);
}

/// Fisher and Yates, by hash.
template <class T>
void shuffle(std::vector<T>& items, std::uint64_t seed, std::uint64_t stream) {
  for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[mix64(seed, stream, i) % i]);
}

glm::dvec2 centre(const Ensemble& e, std::uint32_t cell) {
  return {(cell % e.columns + 0.5) / e.columns, (cell / e.columns + 0.5) / e.rows};
}

std::vector<glm::vec3> centres_of(const Ensemble& e, EnsembleDomain domain) {
  std::vector<glm::vec3> centres(e.cells.size());
  for (std::uint32_t c = 0; c < centres.size(); ++c) centres[c] = spread_place(domain, centre(e, c));
  return centres;
}

/// Who meets whom: in a season of a tournament every set meets every other one once, and no two meetings of a
/// round have a set in common. Those that met in vain and have not changed since need not meet again.
class Tournament {
 public:
  Tournament(std::uint32_t sets, std::uint64_t seed)
      : sets_(sets), seed_(seed), order_(sets), changed_(sets, 1), vain_(std::size_t(sets) * sets) {}

  struct Meeting {
    std::uint32_t a, b;
    bool changed = false;
  };

  std::uint32_t rounds() const { return sets_ + sets_ % 2 - 1; }

  /// The meetings of a round, by the circle method.
  std::vector<Meeting> meetings(std::uint32_t season, std::uint32_t round) {
    if (round == 0) {
      std::iota(order_.begin(), order_.end(), 0u);
      shuffle(order_, seed_, kOrderStream + season);
    }
    ++now_;
    std::vector<Meeting> result;
    const std::uint32_t turning = rounds();
    for (std::uint32_t k = 0; 2 * k < turning + 1; ++k) {
      const std::uint32_t i = k == 0 ? turning : (round + k) % turning, j = (round + turning - k) % turning;
      if (i >= sets_ || j >= sets_) continue;  // an odd number: one has no partner
      const auto [a, b] = std::minmax(order_[i], order_[j]);
      if (vain_[std::size_t(a) * sets_ + b] <= std::max(changed_[a], changed_[b])) result.push_back({a, b});
    }
    return result;
  }

  /// Returns whether anything has changed.
  bool note(const std::vector<Meeting>& meetings) {
    bool any = false;
    for (const Meeting& m : meetings) {
      if (m.changed) changed_[m.a] = changed_[m.b] = now_;
      if (!m.changed) vain_[std::size_t(m.a) * sets_ + m.b] = now_;
      any = any || m.changed;
    }
    return any;
  }

 private:
  std::uint32_t sets_;
  std::uint64_t seed_;
  std::vector<std::uint32_t> order_;
  std::uint32_t now_ = 1;
  std::vector<std::uint32_t> changed_;  ///< in which round a set did last
  std::vector<std::uint32_t> vain_;     ///< [a * sets + b], a < b: in which round they last met in vain
};

}  // namespace

glm::dvec2 into_domain(EnsembleDomain domain, glm::dvec2 u) {
  if (domain != EnsembleDomain::disk) return u;
  const glm::dvec2 p = 2.0 * u - 1.0;
  if (p.x == 0 && p.y == 0) return {0, 0};
  const bool wide = std::abs(p.x) > std::abs(p.y);
  const double radius = wide ? p.x : p.y, angle = std::numbers::pi / 4 * (wide ? p.y / p.x : p.x / p.y);
  return wide ? radius * glm::dvec2(std::cos(angle), std::sin(angle))
              : radius * glm::dvec2(std::sin(angle), std::cos(angle));
}

glm::dvec3 in_space(EnsembleDomain domain, glm::dvec2 u) {
  const glm::dvec2 p = into_domain(domain, u);
  if (domain != EnsembleDomain::cylinder) return {p.x, p.y, 0};
  const double angle = 2 * std::numbers::pi * u.x, z = 2 * u.y - 1,
               radius = std::sqrt(std::max(0.0, 1 - z * z));
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

glm::vec3 spread_place(EnsembleDomain domain, glm::dvec2 u) {
  glm::dvec3 p = in_space(domain, u);
  if (domain == EnsembleDomain::disk) p.z = std::sqrt(std::max(0.0, 1 - p.x * p.x - p.y * p.y));
  return p;
}

bool can_make_ensemble(std::uint32_t points) {
  if (points <= kMostWhole) return points > 0;
  const std::uint32_t wished = wished_sets({.points = points});
  return points <= kMostEnsemblePoints && sets_of_start(points, wished) <= 2 * wished;
}

Ensemble make_ensemble(const EnsembleOptions& options) {
  const std::uint32_t n = options.points;
  if (!can_make_ensemble(n)) {
    throw InputError(
        fmt::format("an ensemble has sets of 1 to {} points, beyond {} none with a large prime factor, and "
                    "{} are asked for",
                    kMostEnsemblePoints, kMostWhole, n));
  }
  Ensemble e = start_ensemble(n, wished_sets(options), options.seed);
  const std::vector<glm::vec3> centres = centres_of(e, options.domain);
  if (n > kMostWhole) {
    const double round_cost = 1.0 * e.sets * n * n;
    swap_near(e, options.domain, centres,
              std::max(8u, static_cast<std::uint32_t>(options.effort / round_cost)), options.seed);
    return e;
  }
  const double meeting_cost = 4.0 * n * n;
  const auto most = static_cast<std::uint64_t>(std::max(options.effort / meeting_cost, 4.0 * e.sets));
  // A thread costs about as much.
  const auto grain = static_cast<std::size_t>(std::max(1.0, 1e6 / meeting_cost));
  Tournament tournament(e.sets, options.seed);
  std::uint64_t met = 0;
  bool any = e.sets > 1 && n > 1;
  for (std::uint32_t season = 0; any && met < most; ++season) {
    any = false;
    for (std::uint32_t round = 0; round < tournament.rounds() && met < most; ++round) {
      auto meetings = tournament.meetings(season, round);
      const auto meet = [&](std::size_t k) {
        auto& m = meetings[k];
        m.changed = swap_cells(options.domain, centres, &e.cells[std::size_t(m.a) * n],
                               &e.cells[std::size_t(m.b) * n], n);
      };
      if (meetings.size() <= grain) {
        for (std::size_t k = 0; k < meetings.size(); ++k) meet(k);
      } else {
        parallel_for(meetings.size(), meet, grain);
      }
      any = tournament.note(meetings) || any;
      met += meetings.size();
    }
  }
  return e;
}

void deal_parts(Ensemble& e, EnsembleDomain domain, std::uint32_t parts) {
  const auto n = static_cast<std::uint32_t>(e.cells.size() / e.sets), points = n / parts;
  if (parts == 1 || points == 1) return;
  const std::vector<glm::vec3> centres = centres_of(e, domain);
  const int sweeps = n > kMostWhole ? 4 : 6;
  parallel_for(e.sets, [&](std::size_t s) {
    // Every part begins with one of each `parts` cells that lie near each other.
    std::uint32_t* const set = &e.cells[s * n];
    std::vector<std::uint32_t> near(set, set + n), deal(parts);
    std::sort(near.begin(), near.end(), [&](std::uint32_t a, std::uint32_t b) {
      return morton_code(a % e.columns, a / e.columns) < morton_code(b % e.columns, b / e.columns);
    });
    for (std::uint32_t i = 0; i < points; ++i) {
      std::iota(deal.begin(), deal.end(), 0u);
      shuffle(deal, s, kPartStream + i);
      for (std::uint32_t p = 0; p < parts; ++p) set[p * points + i] = near[i * parts + deal[p]];
    }
    bool any = true;
    for (int sweep = 0; any && sweep < sweeps; ++sweep) {
      any = false;
      for (std::uint32_t a = 0; a < parts; ++a)
        for (std::uint32_t b = a + 1; b < parts; ++b)
          any = swap_cells(domain, centres, set + a * points, set + b * points, points) || any;
    }
  });
}

double mean_distance_within(const Ensemble& e, EnsembleDomain domain) {
  const std::size_t n = e.cells.size() / e.sets;
  double sum = 0;
  for (std::uint32_t s = 0; s < e.sets; ++s) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        sum += glm::distance(in_space(domain, centre(e, e.cells[s * n + i])),
                             in_space(domain, centre(e, e.cells[s * n + j])));
      }
    }
  }
  return sum / (static_cast<double>(n) * static_cast<double>(n) * e.sets);
}

}  // namespace capcon
