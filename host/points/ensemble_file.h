#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "points/ensemble.h"

namespace capcon {

/// One ensemble as bytes (docs/ensembles.md): a header with magic, version and what the sets are for, the
/// cells, a checksum. Records one after another are a file.
std::string ensemble_record(const Ensemble& ensemble, const EnsembleOptions& options);

struct StoredEnsemble {
  EnsembleOptions options;
  Ensemble ensemble;
};

/// The records of a file; `name` stands in messages. InputError for another magic or version, a wrong
/// checksum, a file cut short, and cells that are not each there once, which would be biased.
std::vector<StoredEnsemble> parse_ensembles(std::string_view bytes, const std::string& name);

/// "square", "disk", "cylinder": what files and messages call a domain.
std::string_view domain_name(EnsembleDomain domain);

}  // namespace capcon
