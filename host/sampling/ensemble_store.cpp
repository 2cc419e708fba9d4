#include "sampling/ensemble_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "base/cache.h"
#include "base/error.h"
#include "base/file.h"
#include "base/hash.h"
#include "base/little_endian.h"
#include "base/sealed.h"
#include "points/ranked_order.h"

namespace capcon {
namespace {

// Of the way ensembles are made: to be raised when the same options give other sets, so that what caches keep
// is made anew.
constexpr int kMaking = 3;

// The same of the ways parts are dealt.
constexpr int kDealing = 2;

// The same of the way sets are ranked.
constexpr int kRanking = 2;
// Distances that dealing computes at least for its result to be kept: a tenth of a second's work.
constexpr double kWorthKeeping = 8e6;

bool same(const EnsembleOptions& a, const EnsembleOptions& b) {
  return a.points == b.points && a.domain == b.domain && a.sets == b.sets && a.seed == b.seed &&
         a.effort == b.effort;
}

/// What the cache has under a name, of these options and as `is_right` wants it; else made now and kept.
template <class Make, class IsRight>
Ensemble cached_or_made(const std::string& name, const EnsembleOptions& options, const Make& make,
                        const IsRight& is_right) {
  const std::filesystem::path folder = cache_folder(), path = folder / name;
  std::error_code error;
  if (!folder.empty() && std::filesystem::is_regular_file(path, error)) {
    try {
      for (StoredEnsemble& stored : parse_ensembles(read_file(path), path.string()))
        if (same(stored.options, options) && is_right(stored.ensemble)) return std::move(stored.ensemble);
    } catch (const std::exception&) {
    }
  }
  Ensemble made = make();
  if (!folder.empty()) {
    try {
      std::filesystem::create_directories(folder);
      write_file(path, ensemble_record(made, options));
    } catch (const std::exception&) {
    }
  }
  return made;
}

/// The cells of each set in the order of their numbers.
std::vector<std::uint32_t> sorted_sets(const Ensemble& e) {
  std::vector<std::uint32_t> cells = e.cells;
  const auto n = static_cast<std::ptrdiff_t>(cells.size() / e.sets);
  for (auto first = cells.begin(); first != cells.end(); first += n) std::sort(first, first + n);
  return cells;
}

bool has_same_sets(const Ensemble& a, const Ensemble& b) {
  return a.columns == b.columns && a.rows == b.rows && a.sets == b.sets && sorted_sets(a) == sorted_sets(b);
}

}  // namespace

const std::vector<std::uint32_t>& shipped_ensemble_sizes() {
  static const std::vector<std::uint32_t> sizes = {1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11,  12, 13,
                                                   14, 15, 16, 20, 24, 32, 36, 48, 64, 96, 128, 256};
  return sizes;
}

EnsembleOptions shipped_ensemble_options(std::uint32_t points, EnsembleDomain domain) {
  return {.points = points, .domain = domain, .sets = std::clamp(16384 / points, 64u, 256u), .effort = 3e9};
}

std::string make_shipped_ensembles(EnsembleDomain domain) {
  std::string bytes;
  for (const std::uint32_t n : shipped_ensemble_sizes()) {
    const EnsembleOptions options = shipped_ensemble_options(n, domain);
    bytes += ensemble_record(make_ensemble(options), options);
  }
  return bytes;
}

Ensemble stored_parts(const Ensemble& ensemble, EnsembleDomain domain, std::uint32_t parts) {
  const auto points = static_cast<std::uint32_t>(ensemble.cells.size() / ensemble.sets);
  const auto deal = [&] {
    Ensemble dealt = ensemble;
    deal_parts(dealt, domain, parts);
    return dealt;
  };
  if (double(points) * points * ensemble.sets < kWorthKeeping) return deal();
  const auto deals_these = [&](const Ensemble& e) { return has_same_sets(e, ensemble); };
  return cached_or_made(
      fmt::format("{}-{}-in-{}-{}-{}.ensembles", domain_name(domain), points, parts, kMaking, kDealing),
      {.points = points, .domain = domain}, deal, deals_these);
}

Ensemble stored_ensemble(std::uint32_t points, EnsembleDomain domain) {
  if (!std::ranges::binary_search(shipped_ensemble_sizes(), points)) {
    const EnsembleOptions options{.points = points, .domain = domain};
    return cached_or_made(
        fmt::format("{}-{}-{}.ensembles", domain_name(domain), points, kMaking), options,
        [&] { return make_ensemble(options); }, [](const Ensemble&) { return true; });
  }
  const std::filesystem::path path = shipped_file(fmt::format("ensembles/{}.ensembles", domain_name(domain)));
  for (StoredEnsemble& stored : parse_ensembles(read_file(path), path.string()))
    if (stored.options.points == points && stored.options.domain == domain) return std::move(stored.ensemble);
  throw InputError(
      fmt::format("{}: holds no sets of {} points; copy the shipped file again", path.string(), points));
}

Ensemble stored_ranked_sets(std::uint32_t points, EnsembleDomain domain) {
  const Ensemble ensemble = stored_ensemble(points, domain);
  return cached_or_made(
      fmt::format("{}-{}-ranked-{}-{}.ensembles", domain_name(domain), points, kMaking, kRanking),
      {.points = points, .domain = domain},
      [&] {
        Ensemble ranked = ensemble;
        rank_cells(ranked, domain);
        return ranked;
      },
      [&](const Ensemble& e) { return has_same_sets(e, ensemble); });
}

ScreenMask stored_screen_mask(std::uint32_t points, EnsembleDomain domain) {
  const Ensemble e = stored_ensemble(points, domain);
  ScreenMask mask{mask_rows(e.sets), {}};
  const std::size_t count = std::size_t(ScreenMask::kColumns) * mask.rows;
  // Which sets a mask is of is part of what its checksum covers.
  const std::string kind = fmt::format("capcon-screen-mask 1 {:016x}",
                                       fnv1a64(ensemble_record(e, {.points = points, .domain = domain})));
  const std::filesystem::path folder = cache_folder(),
                              path = folder / fmt::format("{}-{}.screen-mask", domain_name(domain), points);
  std::error_code error;
  if (!folder.empty() && std::filesystem::is_regular_file(path, error)) {
    if (const auto data = unsealed(kind, read_file(path)); data && data->size() == 2 * count) {
      std::string_view rest = *data;
      for (std::size_t k = 0; k < count; ++k) mask.keys.push_back(take_bytes<std::uint16_t>(rest));
      return mask;
    }
  }
  mask = make_screen_mask(e, domain);
  if (!folder.empty()) {
    std::string data;
    for (const std::uint16_t key : mask.keys) put_bytes(data, key);
    try {
      std::filesystem::create_directories(folder);
      write_file(path, sealed(kind, data));
    } catch (const std::exception&) {
    }
  }
  return mask;
}

}  // namespace capcon
