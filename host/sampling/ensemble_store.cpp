#include "sampling/ensemble_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "base/cache.h"
#include "base/error.h"
#include "base/file.h"

namespace capcon {
namespace {

// Of the way ensembles are made: to be raised when the same options give other sets, so that what caches keep
// is made anew.
constexpr int kMaking = 1;

std::filesystem::path cached_file(const EnsembleOptions& options) {
  const std::filesystem::path folder = cache_folder();
  if (folder.empty()) return folder;
  return folder / fmt::format("{}-{}-{}.ensembles", domain_name(options.domain), options.points, kMaking);
}

bool same(const EnsembleOptions& a, const EnsembleOptions& b) {
  return a.points == b.points && a.domain == b.domain && a.sets == b.sets && a.seed == b.seed &&
         a.effort == b.effort;
}

Ensemble cached_or_made(const EnsembleOptions& options) {
  const std::filesystem::path path = cached_file(options);
  std::error_code error;
  if (!path.empty() && std::filesystem::is_regular_file(path, error)) {
    try {
      for (StoredEnsemble& stored : parse_ensembles(read_file(path), path.string()))
        if (same(stored.options, options)) return std::move(stored.ensemble);
    } catch (const std::exception&) {
    }
  }
  Ensemble made = make_ensemble(options);
  if (!path.empty()) {
    try {
      std::filesystem::create_directories(path.parent_path());
      write_file(path, ensemble_record(made, options));
    } catch (const std::exception&) {
    }
  }
  return made;
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

Ensemble stored_ensemble(std::uint32_t points, EnsembleDomain domain) {
  if (!std::ranges::binary_search(shipped_ensemble_sizes(), points))
    return cached_or_made({.points = points, .domain = domain});
  const std::filesystem::path path = shipped_file(fmt::format("ensembles/{}.ensembles", domain_name(domain)));
  for (StoredEnsemble& stored : parse_ensembles(read_file(path), path.string()))
    if (stored.options.points == points && stored.options.domain == domain) return std::move(stored.ensemble);
  throw InputError(
      fmt::format("{}: holds no sets of {} points; copy the shipped file again", path.string(), points));
}

}  // namespace capcon
