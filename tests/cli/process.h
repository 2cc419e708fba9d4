#pragma once

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <optional>
#include <string>
#include <thread>

#include "cli/program.h"

namespace capcon::testing {

/// The program in the background, with a shell's words; what it says goes to files.
class Process {
 public:
  explicit Process(const std::string& words) {
    const std::string command = "exec " CAPCON_PROGRAM " " + words + " >" + (folder_ / "out") + " 2>" +
                                (folder_ / "err") + " </dev/null";
    pid_ = ::fork();
    if (pid_ == 0) {
      ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      ::_exit(127);
    }
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() {
    if (pid_ > 0) end(SIGKILL);
  }

  void send(int signal) const { ::kill(pid_, signal); }

  /// Waits for its end, for so long at most.
  std::optional<Outcome> wait(double seconds) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    for (;;) {
      int status = 0;
      if (::waitpid(pid_, &status, WNOHANG) == pid_) {
        pid_ = 0;
        return Outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), contents(folder_ / "out"),
                       contents(folder_ / "err")};
      }
      if (std::chrono::steady_clock::now() >= until) return std::nullopt;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }

  /// Sends a signal and waits for the end; the exit code is minus the signal where that ended it.
  Outcome end(int signal) {
    send(signal);
    return *wait(1e9);
  }

 private:
  Folder folder_;
  pid_t pid_ = 0;
};

inline double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace capcon::testing
