#include "points/ensemble_file.h"

#include <fmt/format.h>

#include <bit>

#include "base/error.h"
#include "base/hash.h"
#include "base/little_endian.h"

namespace capcon {
namespace {

constexpr std::string_view kMagic = "CAPENSEM";
constexpr std::uint32_t kVersion = 1;
constexpr std::uint32_t kMostCells = 1u << 22;
constexpr std::size_t kHeader = 8 + 7 * 4 + 2 * 8;

/// Two bytes a cell where they do.
bool is_short(std::uint64_t cells) {
  return cells <= 0x10000;
}

}  // namespace

std::string_view domain_name(EnsembleDomain domain) {
  return domain == EnsembleDomain::square ? "square" : domain == EnsembleDomain::disk ? "disk" : "cylinder";
}

std::string ensemble_record(const Ensemble& e, const EnsembleOptions& options) {
  std::string bytes(kMagic);
  for (const std::uint32_t word : {kVersion, static_cast<std::uint32_t>(options.domain), options.points,
                                   options.sets, e.columns, e.rows, e.sets})
    put_bytes(bytes, word);
  put_bytes(bytes, options.seed);
  put_bytes(bytes, std::bit_cast<std::uint64_t>(options.effort));
  for (const std::uint32_t c : e.cells) {
    if (is_short(e.cells.size())) {
      put_bytes(bytes, static_cast<std::uint16_t>(c));
    } else {
      put_bytes(bytes, c);
    }
  }
  put_bytes(bytes, fnv1a64(bytes));
  return bytes;
}

std::vector<StoredEnsemble> parse_ensembles(std::string_view bytes, const std::string& name) {
  std::vector<StoredEnsemble> all;
  const auto fail = [&](const char* what) {
    throw InputError(fmt::format("{}: record {} of the ensembles {}; make or copy the file again", name,
                                 all.size() + 1, what));
  };
  while (!bytes.empty()) {
    const std::string_view record = bytes;
    if (bytes.size() < kHeader) fail("is cut short");
    if (bytes.substr(0, kMagic.size()) != kMagic) fail("does not begin with CAPENSEM");
    bytes.remove_prefix(kMagic.size());
    if (take_bytes<std::uint32_t>(bytes) != kVersion) fail("is of another version than 1");
    StoredEnsemble stored;
    const auto domain = take_bytes<std::uint32_t>(bytes);
    stored.options.domain = static_cast<EnsembleDomain>(domain);
    stored.options.points = take_bytes<std::uint32_t>(bytes);
    stored.options.sets = take_bytes<std::uint32_t>(bytes);
    Ensemble& e = stored.ensemble;
    e.columns = take_bytes<std::uint32_t>(bytes);
    e.rows = take_bytes<std::uint32_t>(bytes);
    e.sets = take_bytes<std::uint32_t>(bytes);
    stored.options.seed = take_bytes<std::uint64_t>(bytes);
    stored.options.effort = std::bit_cast<double>(take_bytes<std::uint64_t>(bytes));
    const std::uint64_t cells = std::uint64_t(e.columns) * e.rows;
    if (domain > 2 || cells == 0 || cells > kMostCells ||
        std::uint64_t(e.sets) * stored.options.points != cells)
      fail("has sizes that do not fit each other");
    const std::size_t body = cells * (is_short(cells) ? 2 : 4);
    if (bytes.size() < body + 8) fail("is cut short");
    e.cells.resize(cells);
    std::vector<char> seen(cells);
    for (std::uint32_t& c : e.cells) {
      c = is_short(cells) ? take_bytes<std::uint16_t>(bytes) : take_bytes<std::uint32_t>(bytes);
      if (c >= cells || seen[c] != 0) fail("does not hold every cell once");
      seen[c] = 1;
    }
    if (take_bytes<std::uint64_t>(bytes) != fnv1a64(record.substr(0, kHeader + body)))
      fail("has a wrong checksum");
    all.push_back(std::move(stored));
  }
  return all;
}

}  // namespace capcon
