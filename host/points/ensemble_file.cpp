#include "points/ensemble_file.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>

#include "base/error.h"
#include "base/hash.h"

namespace capcon {
namespace {

constexpr std::string_view kMagic = "CAPENSEM";
constexpr std::uint32_t kVersion = 1;
constexpr std::uint32_t kMostCells = 1u << 22;
constexpr std::size_t kHeader = 8 + 7 * 4 + 2 * 8;

/// Little-endian whatever the machine's order.
template <class T>
void put(std::string& bytes, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
}

template <class T>
T take(std::string_view& bytes) {
  T value = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i)
    value |= static_cast<T>(static_cast<T>(static_cast<unsigned char>(bytes[i])) << (8 * i));
  bytes.remove_prefix(sizeof(T));
  return value;
}

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
    put(bytes, word);
  put(bytes, options.seed);
  put(bytes, std::bit_cast<std::uint64_t>(options.effort));
  for (const std::uint32_t c : e.cells) {
    if (is_short(e.cells.size())) {
      put(bytes, static_cast<std::uint16_t>(c));
    } else {
      put(bytes, c);
    }
  }
  put(bytes, fnv1a64(bytes));
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
    if (take<std::uint32_t>(bytes) != kVersion) fail("is of another version than 1");
    StoredEnsemble stored;
    const auto domain = take<std::uint32_t>(bytes);
    stored.options.domain = static_cast<EnsembleDomain>(domain);
    stored.options.points = take<std::uint32_t>(bytes);
    stored.options.sets = take<std::uint32_t>(bytes);
    Ensemble& e = stored.ensemble;
    e.columns = take<std::uint32_t>(bytes);
    e.rows = take<std::uint32_t>(bytes);
    e.sets = take<std::uint32_t>(bytes);
    stored.options.seed = take<std::uint64_t>(bytes);
    stored.options.effort = std::bit_cast<double>(take<std::uint64_t>(bytes));
    const std::uint64_t cells = std::uint64_t(e.columns) * e.rows;
    if (domain > 2 || cells == 0 || cells > kMostCells ||
        std::uint64_t(e.sets) * stored.options.points != cells)
      fail("has sizes that do not fit each other");
    const std::size_t body = cells * (is_short(cells) ? 2 : 4);
    if (bytes.size() < body + 8) fail("is cut short");
    e.cells.resize(cells);
    std::vector<char> seen(cells);
    for (std::uint32_t& c : e.cells) {
      c = is_short(cells) ? take<std::uint16_t>(bytes) : take<std::uint32_t>(bytes);
      if (c >= cells || seen[c] != 0) fail("does not hold every cell once");
      seen[c] = 1;
    }
    if (take<std::uint64_t>(bytes) != fnv1a64(record.substr(0, kHeader + body))) fail("has a wrong checksum");
    all.push_back(std::move(stored));
  }
  return all;
}

}  // namespace capcon
