#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/statistics.h"

namespace capcon {

// How figures are written in tables and sentences; "–" where there is none.

/// "2.97e-3": three digits.
std::string scientific(double v);
/// "0.812", "12.3", "143": about three digits, no exponent.
std::string short_number(double v);
/// "±1.2 %": half the width of an interval that is symmetric as a factor.
std::string percent_around(const Interval& v);
/// "0.81 (0.79–0.83)"
std::string with_range(const Interval& v);
/// "0.79–0.83"
std::string range(const Interval& v);
/// "830 µs", "12.3 ms", "1.42 s"
std::string duration(double seconds);
/// "1,602,392"
std::string grouped(std::uint64_t count);
/// "16", "8 and 16", "4, 8 and 16"
std::string enumerate(const std::vector<std::string>& words);

}  // namespace capcon
