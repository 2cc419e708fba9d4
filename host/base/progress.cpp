#include "base/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace capcon {

Progress::Progress(std::string label, double total, bool quiet)
    : label_(std::move(label)), total_(total), visible_(!quiet && ::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (drawn_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::update(double done, const std::string& note) {
  using namespace std::chrono_literals;
  const auto now = Clock::now();
  if (!visible_ || now - start_ < 1s || now - last_ < 100ms) return;
  last_ = now;
  drawn_ = true;
  const double fraction = total_ > 0 ? std::clamp(done / total_, 0.0, 1.0) : 0.0;
  const double spent = std::chrono::duration<double>(now - start_).count();
  const double left = fraction > 0 ? spent * (1 - fraction) / fraction : 0;
  constexpr int kWidth = 32;
  const int filled = static_cast<int>(fraction * kWidth);
  fmt::print(stderr, "\r\x1b[K{} [{}{}] {:3.0f} %  {:.0f} s left  {}", label_, std::string(filled, '#'),
             std::string(kWidth - filled, '.'), 100 * fraction, left, note);
  std::fflush(stderr);
}

}  // namespace capcon
