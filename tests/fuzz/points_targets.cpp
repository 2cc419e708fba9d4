// Point files, densities as formulas, ensembles.
#include <bit>

#include "base/hash.h"
#include "base/little_endian.h"
#include "fuzz/target.h"
#include "points/ensemble_file.h"
#include "points/formula.h"
#include "points/import_points.h"
#include "points/point_set.h"

namespace capcon::fuzz {
namespace {

void check_sets(const std::vector<Points>& sets) {
  require(!sets.empty(), "there is a set");
  for (const Points& points : sets) {
    require(!points.empty(), "a set has points");
    for (const glm::dvec2& p : points)
      require(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1, "points lie in [0, 1)^2");
  }
  require(parse_points(format_points(sets), "again") == sets, "what is written is read again");
}

void check_ensembles(std::string_view bytes) {
  std::string again;
  for (const StoredEnsemble& stored : parse_ensembles(bytes, "f.ensembles")) {
    const Ensemble& e = stored.ensemble;
    require(e.sets >= 1 && e.cells.size() == std::size_t(e.columns) * e.rows, "sizes fit each other");
    require(e.cells.size() % e.sets == 0, "sets are equal");
    again += ensemble_record(e, stored.options);
  }
  require(again == bytes, "what was read is written again");
}

}  // namespace

void read_points_text(std::string_view bytes) {
  check_sets(parse_points(bytes, "f.txt"));
}

void read_points_csv(std::string_view bytes) {
  check_sets(parse_csv_points(bytes, "f.csv"));
}

void read_points_binary(std::string_view bytes) {
  check_sets(parse_binary_points(bytes, "f.bin"));
}

void read_points_npy(std::string_view bytes) {
  check_sets(parse_npy_points(bytes, "f.npy"));
}

void read_formula(std::string_view bytes) {
  const Formula formula(bytes);
  for (const double x : {0.0, 0.5, 1.0}) formula(x, 1 - x / 3);
}

void read_ensembles(std::string_view bytes) {
  // With the checksum of a single record made right, which no mutation finds.
  std::string mended(bytes.substr(0, bytes.size() < 8 ? 0 : bytes.size() - 8));
  put_bytes(mended, fnv1a64(mended));
  check({"ensembles", check_ensembles}, mended);
  check_ensembles(bytes);
}

}  // namespace capcon::fuzz
