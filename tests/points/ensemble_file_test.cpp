#include "points/ensemble_file.h"

#include <gtest/gtest.h>

#include <functional>

#include "base/error.h"
#include "base/hash.h"

namespace capcon {
namespace {

EnsembleOptions options_of(std::uint32_t points, EnsembleDomain domain) {
  return {.points = points, .domain = domain, .seed = 7, .effort = 1e6};
}

TEST(EnsembleFile, GivesBackWhatWasWritten) {
  const EnsembleOptions small = options_of(6, EnsembleDomain::disk),
                        large = {.points = 20, .domain = EnsembleDomain::cylinder, .sets = 4000, .effort = 1};
  const Ensemble a = make_ensemble(small), b = make_ensemble(large);
  ASSERT_GT(b.cells.size(), 65536u);  // four bytes a cell
  const auto read = parse_ensembles(ensemble_record(a, small) + ensemble_record(b, large), "x");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].ensemble.cells, a.cells);
  EXPECT_EQ(read[0].ensemble.sets, a.sets);
  EXPECT_EQ(read[0].options.seed, 7u);
  EXPECT_EQ(read[0].options.effort, 1e6);
  EXPECT_EQ(read[1].ensemble.cells, b.cells);
  EXPECT_EQ(read[1].ensemble.columns, b.columns);
  EXPECT_EQ(read[1].options.domain, EnsembleDomain::cylinder);
}

TEST(EnsembleFile, RefusesWhatIsBroken) {
  const EnsembleOptions options = options_of(4, EnsembleDomain::square);
  const std::string good = ensemble_record(make_ensemble(options), options);
  const auto refused = [&](const char* part, const std::function<void(std::string&)>& change) {
    std::string bytes = good;
    change(bytes);
    try {
      parse_ensembles(bytes, "sets.bin");
      FAIL() << part;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("sets.bin"), std::string::npos);
    }
  };
  refused("CAPENSEM", [](std::string& b) { b[0] = 'X'; });
  refused("version", [](std::string& b) { b[8] = 2; });
  refused("sizes", [](std::string& b) { b[16] = 5; });    // points
  refused("sizes", [](std::string& b) { b[12] = 3; });    // domain
  refused("sizes", [](std::string& b) { b[27] = 127; });  // columns: more cells than memory
  refused("every cell once", [](std::string& b) { b[52] = b[54], b[53] = b[55]; });
  refused("checksum", [](std::string& b) { b[36] ^= 1; });  // seed
  refused("checksum", [](std::string& b) { b.back() ^= 1; });
  for (const std::size_t left : {std::size_t(3), std::size_t(51), good.size() - 1})
    refused("cut short", [&](std::string& b) { b.resize(left); });
  refused("record 2", [&](std::string& b) { b += "more"; });
}

}  // namespace
}  // namespace capcon
