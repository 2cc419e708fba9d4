#include "base/stop.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "base/descriptor.h"

namespace capcon {
namespace {

/// Signals belong to the process, and so does what they need.
struct Stop {
  std::mutex mutex;
  std::string message = "no file is left half written; give the same command again";
  std::vector<std::filesystem::path> temporaries;
};

/// Never destroyed: the thread that waits for signals lives as long as the process.
Stop& the_stop() {
  static Stop& stop = *new Stop;
  return stop;
}

[[noreturn]] void end(const std::string& program, int signal) {
  Stop& stop = the_stop();
  const std::lock_guard held(stop.mutex);  // kept to the end: nothing is made or renamed from here on
  std::error_code ignored;
  for (const auto& path : stop.temporaries) std::filesystem::remove_all(path, ignored);
  const std::string_view clear = ::isatty(STDERR_FILENO) == 1 ? "\r\x1b[K" : "";  // the progress bar
  write_all(STDERR_FILENO, fmt::format("{}{}: stopped; {}\n", clear, program, stop.message));
  ::_exit(128 + signal);
}

}  // namespace

void end_on_signals(const std::string& program) {
  the_stop();
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction now {};
    ::sigaction(signal, nullptr, &now);
    if (signal == SIGHUP && now.sa_handler == SIG_IGN) continue;
    ::signal(signal, SIG_DFL);
    sigaddset(&signals, signal);
  }
  ::signal(SIGXFSZ, SIG_IGN);
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // inherited by all threads: this one alone receives them
  std::thread([program, signals] {
    int signal = 0;
    while (::sigwait(&signals, &signal) != 0) {
    }
    ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);  // the next one ends the process by itself
    end(program, signal);
  }).detach();
}

StopMessage::StopMessage(std::string message) : before_(std::move(message)) {
  const std::lock_guard held(the_stop().mutex);
  std::swap(before_, the_stop().message);
}

StopMessage::~StopMessage() {
  const std::lock_guard held(the_stop().mutex);
  std::swap(before_, the_stop().message);
}

void StopMessage::say(std::string message) {
  const std::lock_guard held(the_stop().mutex);
  the_stop().message = std::move(message);
}

StopLater::StopLater() : held_(the_stop().mutex) {}

void register_temporary(const std::filesystem::path& path) {
  the_stop().temporaries.push_back(path);
}

void forget_temporary(const std::filesystem::path& path) {
  auto& all = the_stop().temporaries;
  const auto found = std::find(all.begin(), all.end(), path);
  if (found != all.end()) all.erase(found);
}

}  // namespace capcon
