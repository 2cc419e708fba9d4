// Replays the fuzzers' corpora, damaged inputs that once did harm among them, without clang.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "fuzz/target.h"

namespace capcon::fuzz {
namespace {

namespace fs = std::filesystem;
const fs::path kCorpus = fs::path(CAPCON_SOURCE_DIR) / "tests/fuzz/corpus";

std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Corpus, EveryTargetHasOne) {
  std::set<std::string> names, folders;
  for (const Target& target : targets()) names.emplace(target.name);
  for (const auto& folder : fs::directory_iterator(kCorpus)) folders.insert(folder.path().filename());
  EXPECT_EQ(names, folders);
}

TEST(Corpus, EveryInputEndsInAValueOrASentence) {
  for (const Target& target : targets()) {
    int values = 0, inputs = 0;
    for (const auto& file : fs::directory_iterator(kCorpus / target.name)) {
      const std::string bytes = contents(file.path());
      ++inputs;
      EXPECT_NO_THROW(check(target, bytes)) << target.name << ": " << file.path().filename();
      try {
        target.read(bytes);
        ++values;
      } catch (const std::exception&) {
      }
    }
    EXPECT_GT(inputs, 1) << target.name;
    EXPECT_GT(values, 0) << target.name << ": no seed is valid, so the checks of values never run";
  }
}

/// Short files, and every file with one byte changed, at regular places.
TEST(Corpus, CutAndFlippedInputsToo) {
  for (const Target& target : targets()) {
    for (const auto& file : fs::directory_iterator(kCorpus / target.name)) {
      const std::string bytes = contents(file.path());
      const std::size_t step = bytes.size() / 8 + 1;
      for (std::size_t at = 0; at < bytes.size(); at += step) {
        EXPECT_NO_THROW(check(target, bytes.substr(0, at))) << file.path() << " cut at " << at;
        std::string flipped = bytes;
        flipped[at] = static_cast<char>(flipped[at] ^ 0x80);
        EXPECT_NO_THROW(check(target, flipped)) << file.path() << " flipped at " << at;
      }
    }
  }
}

TEST(Corpus, ABrokenPromiseIsSeen) {
  const Target broken{"broken", [](std::string_view) { require(false, "a promise"); }};
  EXPECT_THROW(check(broken, ""), Broken);
  const Target crash{"crash", [](std::string_view) { throw std::bad_alloc(); }};
  EXPECT_THROW(check(crash, ""), std::bad_alloc);
}

}  // namespace
}  // namespace capcon::fuzz
