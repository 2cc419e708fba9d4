#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "points/ensemble_file.h"
#include "points/screen_mask.h"

namespace capcon {

/// The ensemble of sets of `points` in a domain, wherever it is found first: shipped for the usual sizes
/// (ensembles/DOMAIN.ensembles), kept from before in the user's cache, or made now and kept. A broken file of
/// the cache is ignored and written anew; one that cannot be written is not an error. InputError when a
/// shipped file is missing or broken.
Ensemble stored_ensemble(std::uint32_t points, EnsembleDomain domain);

/// `ensemble` with its sets' cells ordered part by part (deal_parts), from the user's cache where that takes
/// long and it has been done before. A file that is broken, or deals other sets, is ignored and written anew.
Ensemble stored_parts(const Ensemble& ensemble, EnsembleDomain domain, std::uint32_t parts);

/// stored_ensemble's sets with their cells ranked (rank_cells): made now, or found in the user's cache where
/// that takes long.
Ensemble stored_ranked_sets(std::uint32_t points, EnsembleDomain domain);

/// The mask of stored_ensemble's sets: from the user's cache, or made now (seconds) and kept there.
ScreenMask stored_screen_mask(std::uint32_t points, EnsembleDomain domain);

/// The sizes that are shipped: 1 to 16, 20, 24, 32, 36, 48, 64, 96, 128, 256.
const std::vector<std::uint32_t>& shipped_ensemble_sizes();

/// How the shipped ones are made: more and finer cells, more swaps.
EnsembleOptions shipped_ensemble_options(std::uint32_t points, EnsembleDomain domain);

/// The bytes of ensembles/DOMAIN.ensembles.
std::string make_shipped_ensembles(EnsembleDomain domain);

}  // namespace capcon
