#pragma once

#include <filesystem>
#include <mutex>
#include <string>

namespace capcon {

/// From here on SIGINT (Ctrl-C), SIGTERM and SIGHUP (unless ignored, as under nohup) end the program at once,
/// whatever it is doing: temporary files of PendingFile are removed, one sentence says what is kept, and the
/// exit code is 128 and the signal's number (130, 143, 129). A second signal does not even wait for that. A
/// limit of file sizes (SIGXFSZ) becomes an error of the write. To be called once, before any other thread
/// starts.
///
/// Nothing has to ask whether it should stop: files are complete or absent, and logs are whole lines, at any
/// moment, as they must be for kill -9.
void end_on_signals(const std::string& program);

/// While it lives, what is said when a signal ends the program; without one: that no file is left half
/// written.
class StopMessage {
 public:
  explicit StopMessage(std::string message);
  StopMessage(const StopMessage&) = delete;
  StopMessage& operator=(const StopMessage&) = delete;
  ~StopMessage();

  void say(std::string message);

 private:
  std::string before_;
};

/// While it lives no signal ends the program: for the moments between a file's making and its registration.
class StopLater {
 public:
  StopLater();

 private:
  std::unique_lock<std::mutex> held_;
};

/// Temporary files and folders that are removed when a signal ends the program. To be called while a
/// StopLater lives.
void register_temporary(const std::filesystem::path& path);
void forget_temporary(const std::filesystem::path& path);

}  // namespace capcon
