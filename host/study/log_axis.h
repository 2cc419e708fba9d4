#pragma once

#include <string>
#include <vector>

namespace capcon {

/// A logarithmic axis: where values lie on paper, and its ticks.
class LogAxis {
 public:
  struct Tick {
    double value = 0;
    std::string label;  ///< empty for a minor tick
  };
  enum class Style {
    decades,  ///< 10⁻³ 10⁻² ...; with 2 and 5 between when there are few
    counts,   ///< powers of two: sample counts
    seconds,  ///< 1 ms, 10 ms, ...
    plain     ///< 0.5 0.7 1 1.5 2: ratios near one
  };

  /// Covers [low, high] (> 0), widened a little, on paper from `start` to `end`.
  LogAxis(double low, double high, double start, double end, Style style);

  double place(double value) const;
  const std::vector<Tick>& ticks() const { return ticks_; }
  double low() const { return low_; }
  double high() const { return high_; }

 private:
  void add(double value, std::string label);

  double low_, high_, start_, end_;
  std::vector<Tick> ticks_;
};

}  // namespace capcon
