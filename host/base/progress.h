#pragma once

#include <chrono>
#include <string>

namespace capcon {

/// A progress bar on stderr. It appears only after a second, only where a person watches (stderr is a
/// terminal), and never when quiet; it clears itself when it is destroyed.
class Progress {
 public:
  Progress(std::string label, double total, bool quiet = false);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// `done` of `total` units are finished; `note` is shown behind the bar.
  void update(double done, const std::string& note = {});

 private:
  using Clock = std::chrono::steady_clock;
  std::string label_;
  double total_;
  bool visible_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace capcon
