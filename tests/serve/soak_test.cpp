// Many comparisons, and nothing is held after them.
#include <gtest/gtest.h>
#include <malloc.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <limits>

#include "serve/served.h"

namespace capcon {
namespace {

using nlohmann::json;
using testing::Served;
using testing::small;
using testing::small_scene;

/// Threads, open files and resident pages of this process.
std::array<long, 3> held() {
  const auto entries = [](const char* folder) {
    return std::distance(std::filesystem::directory_iterator(folder), {});
  };
  long size = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> size >> resident;
  return {entries("/proc/self/task"), entries("/proc/self/fd"), resident};
}

TEST(Serve, HoldsNothingAfterManyStartsAndCancels) {
  const testing::Folder folder;
  const Served served(15000, small_scene(folder));
  const auto turn = [&](int i) {
    json body = small();
    body["width"] = 16 + i % 20;
    ASSERT_EQ(served.start(body)->status, 201);
    served.client().Get("/page.js");
    if (i % 7 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(60));
    ASSERT_EQ(served.client().Post("/api/leave?client=me")->status, 200);
  };
  const auto settled = [] {
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    ::malloc_trim(0);  // what the heap keeps for later is no leak
    return held();
  };
  for (int i = 0; i < 40; ++i) turn(i);
  const auto first = settled();
  // What is kept once (a device's caches, heaps of threads) comes some time; a leak grows in every window.
  long least = std::numeric_limits<long>::max(), before = first[2];
  auto last = first;
  for (int window = 0; window < 3; ++window) {
    for (int i = 0; i < 80; ++i) turn(i);
    last = settled();
    least = std::min(least, last[2] - before);
    before = last[2];
  }
  EXPECT_LE(last[0], first[0] + 4);
  EXPECT_LE(last[1], first[1] + 8);
  EXPECT_LE(least, 6 * 256) << "pages of 4 KiB: 6 MiB";
}

}  // namespace
}  // namespace capcon
