#include "sampling/ensemble_store.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "base/file.h"

namespace capcon {
namespace {

namespace fs = std::filesystem;

/// The user's cache in a folder of its own, while it lives.
class OtherCache {
 public:
  OtherCache()  // a name a test: they run side by side
      : folder_(fs::path(testing::TempDir()) /
                (std::string("capcon-ensembles-") +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {
    if (const char* old = std::getenv("XDG_CACHE_HOME")) old_ = old;
    fs::remove_all(folder_);
    setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
  }
  ~OtherCache() {
    if (old_.empty()) {
      unsetenv("XDG_CACHE_HOME");
    } else {
      setenv("XDG_CACHE_HOME", old_.c_str(), 1);
    }
    fs::remove_all(folder_);
  }
  fs::path folder() const { return folder_ / "capcon"; }

 private:
  fs::path folder_;
  std::string old_;
};

TEST(EnsembleStore, KeepsWhatItMakes) {
  const OtherCache cache;
  const Ensemble made = stored_ensemble(17, EnsembleDomain::disk);
  ASSERT_FALSE(fs::is_empty(cache.folder()));
  const fs::path file = fs::directory_iterator(cache.folder())->path();
  const std::string kept = read_file(file);
  // What the file says is what comes: another deal of the same cells.
  StoredEnsemble stored = parse_ensembles(kept, "kept").at(0);
  std::swap(stored.ensemble.cells[0], stored.ensemble.cells[20]);
  write_file(file, ensemble_record(stored.ensemble, stored.options));
  EXPECT_EQ(stored_ensemble(17, EnsembleDomain::disk).cells, stored.ensemble.cells);
  // Not when it is broken, or of other options; then it is written anew.
  std::string broken = kept;
  broken[100] ^= 1;
  write_file(file, broken);
  EXPECT_EQ(stored_ensemble(17, EnsembleDomain::disk).cells, made.cells);
  EXPECT_EQ(read_file(file), kept);
  stored.options.effort = 1;
  write_file(file, ensemble_record(stored.ensemble, stored.options));
  EXPECT_EQ(stored_ensemble(17, EnsembleDomain::disk).cells, made.cells);
  EXPECT_EQ(read_file(file), kept);
}

TEST(EnsembleStore, KeepsPartsThatTakeLong) {
  const OtherCache cache;
  const Ensemble small = stored_ensemble(16, EnsembleDomain::disk);
  stored_parts(small, EnsembleDomain::disk, 4);
  EXPECT_FALSE(fs::exists(cache.folder())) << "not worth a file";
  const Ensemble large =
      make_ensemble({.points = 512, .domain = EnsembleDomain::disk, .sets = 64, .effort = 1});
  const Ensemble dealt = stored_parts(large, EnsembleDomain::disk, 4);
  const fs::path file = fs::directory_iterator(cache.folder())->path();
  const std::string kept = read_file(file);
  // What the file says is what comes: cells of a set in another order.
  StoredEnsemble stored = parse_ensembles(kept, "kept").at(0);
  std::swap(stored.ensemble.cells[0], stored.ensemble.cells[500]);
  write_file(file, ensemble_record(stored.ensemble, stored.options));
  EXPECT_EQ(stored_parts(large, EnsembleDomain::disk, 4).cells, stored.ensemble.cells);
  // Not when it deals other sets, or is broken.
  std::swap(stored.ensemble.cells[0], stored.ensemble.cells[512]);
  write_file(file, ensemble_record(stored.ensemble, stored.options));
  EXPECT_EQ(stored_parts(large, EnsembleDomain::disk, 4).cells, dealt.cells);
  EXPECT_EQ(read_file(file), kept);
  write_file(file, kept.substr(0, kept.size() / 2));
  EXPECT_EQ(stored_parts(large, EnsembleDomain::disk, 4).cells, dealt.cells);
  EXPECT_EQ(read_file(file), kept);
}

TEST(EnsembleStore, NeedsNoCache) {
  const OtherCache cache;
  fs::create_directories(cache.folder().parent_path());
  write_file(cache.folder(), "a file where the folder should be");
  EXPECT_EQ(stored_ensemble(18, EnsembleDomain::square).cells.size() % 18, 0u);
}

TEST(EnsembleStore, ShipsTheUsualSizes) {
  std::uintmax_t bytes = 0;
  for (const EnsembleDomain domain :
       {EnsembleDomain::disk, EnsembleDomain::square, EnsembleDomain::cylinder}) {
    const fs::path path = shipped_file("ensembles/" + std::string(domain_name(domain)) + ".ensembles");
    bytes += fs::file_size(path);
    const auto all = parse_ensembles(read_file(path), path.string());
    ASSERT_EQ(all.size(), shipped_ensemble_sizes().size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      const EnsembleOptions recipe = shipped_ensemble_options(shipped_ensemble_sizes()[i], domain);
      EXPECT_EQ(all[i].options.points, recipe.points);
      EXPECT_EQ(all[i].options.sets, recipe.sets);
      EXPECT_EQ(all[i].options.effort, recipe.effort);
      EXPECT_EQ(all[i].options.domain, domain);
      if (recipe.points == 3) {
        EXPECT_EQ(all[i].ensemble.cells, make_ensemble(recipe).cells) << "another recipe";
      }
    }
  }
  EXPECT_LT(bytes, 8u << 20);
}

}  // namespace
}  // namespace capcon
