#include "base/file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/stop.h"

namespace capcon {
namespace {

namespace fs = std::filesystem;

class Files : public ::testing::Test {
 protected:
  Files() {
    std::string pattern = (fs::temp_directory_path() / "capcon-file-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~Files() override { fs::remove_all(folder_); }
  std::size_t count() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

  fs::path folder_;
};

TEST_F(Files, AFileIsTheOldOneUntilItIsTheNewOne) {
  write_file(folder_ / "a", "old");
  {
    PendingFile pending(folder_ / "a");
    ASSERT_TRUE(write_all(pending.descriptor(), "half"));
    EXPECT_EQ(pending.path(), folder_ / "a.writing");
    EXPECT_EQ(read_file(folder_ / "a"), "old");
  }
  EXPECT_EQ(read_file(folder_ / "a"), "old");
  EXPECT_EQ(count(), 1u);
  write_file(folder_ / "a", "new");
  EXPECT_EQ(read_file(folder_ / "a"), "new");
  EXPECT_EQ(count(), 1u);
}

TEST_F(Files, WhatAKilledWriterLeftIsTakenOver) {
  std::ofstream(folder_ / "a.writing") << "much longer than what follows";
  write_file(folder_ / "a", "short");
  EXPECT_EQ(read_file(folder_ / "a"), "short");
  EXPECT_EQ(count(), 1u);
}

TEST_F(Files, TwoWritersDoNotMeet) {
  PendingFile first(folder_ / "a");
  PendingFile second(folder_ / "a");
  EXPECT_NE(first.path(), second.path());
  ASSERT_TRUE(write_all(first.descriptor(), "first"));
  ASSERT_TRUE(write_all(second.descriptor(), "second"));
  second.commit();
  EXPECT_EQ(read_file(folder_ / "a"), "second");
  first.commit();
  EXPECT_EQ(read_file(folder_ / "a"), "first");
  EXPECT_EQ(count(), 1u);
}

TEST_F(Files, ManyWritersOfOneFileLeaveOneWholeFile) {
  {
    std::vector<std::jthread> writers;
    for (int t = 0; t < 4; ++t)
      writers.emplace_back([&, t] {
        for (int i = 0; i < 20; ++i) write_file(folder_ / "a", std::string(5000, char('a' + t)));
      });
  }
  const std::string bytes = read_file(folder_ / "a");
  EXPECT_EQ(bytes, std::string(5000, bytes[0]));
  EXPECT_EQ(count(), 1u);
}

TEST_F(Files, ALinkStaysAndItsFileIsWritten) {
  fs::create_directory(folder_ / "sub");
  write_file(folder_ / "sub/real", "old");
  fs::create_symlink("sub/real", folder_ / "link");
  write_file(folder_ / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(read_file(folder_ / "sub/real"), "new");
}

TEST_F(Files, APipeIsWrittenStraight) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  check_writable(folder_ / "pipe");
  std::string got;
  std::jthread reader([&] { got = read_file(folder_ / "pipe"); });
  write_file(folder_ / "pipe", "through");
  reader.join();
  EXPECT_EQ(got, "through");
  EXPECT_TRUE(fs::is_fifo(folder_ / "pipe"));
  EXPECT_EQ(count(), 1u);
}

TEST_F(Files, WhatCannotBeWrittenIsSaid) {
  const auto message = [](const fs::path& path) -> std::string {
    try {
      write_file(path, "x");
    } catch (const Failure& failure) {
      return failure.what();
    }
    return "";
  };
  fs::create_directory(folder_ / "d");
  EXPECT_NE(message(folder_ / "d").find("it is a directory; name a file in it"), std::string::npos);
  EXPECT_NE(message(folder_ / "no/such").find("choose a folder that is there"), std::string::npos);
  EXPECT_NE(message("/dev/full").find("No space left on device; make room"), std::string::npos);
  EXPECT_THROW(check_writable(folder_ / "no/such"), Failure);
  EXPECT_THROW(check_writable(folder_ / "d"), Failure);
  EXPECT_EQ(count(), 1u);
}

// A process of its own: a signal comes while a file is half written.
TEST_F(Files, ASignalRemovesWhatIsHalfWritten) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    write_file(folder_ / "a", "old");
    EXPECT_EXIT(
        {
          end_on_signals("test");
          PendingFile pending(folder_ / "a");
          const StopMessage stop("this is kept");
          write_all(pending.descriptor(), "half");
          ::kill(::getpid(), signal);
          for (;;) ::pause();
        },
        ::testing::ExitedWithCode(128 + signal), "test: stopped; this is kept");
    EXPECT_EQ(read_file(folder_ / "a"), "old");
    EXPECT_EQ(count(), 1u);
  }
}

TEST_F(Files, ASecondSignalDoesNotWait) {
  EXPECT_EXIT(
      {
        end_on_signals("test");
        const StopLater never;
        ::kill(::getpid(), SIGTERM);
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        ::kill(::getpid(), SIGTERM);
        for (;;) ::pause();
      },
      ::testing::KilledBySignal(SIGTERM), "");
}

}  // namespace
}  // namespace capcon
