#include "study/format.h"

#include <fmt/format.h>

#include <cmath>

namespace capcon {

std::string scientific(double v) {
  if (!std::isfinite(v)) return "–";
  if (v == 0) return "0";
  std::string text = fmt::format("{:.2e}", v);  // 2.97e-03
  const std::size_t e = text.find('e');
  const int exponent = std::stoi(text.substr(e + 1));
  return fmt::format("{}e{}", text.substr(0, e), exponent);
}

std::string short_number(double v) {
  if (!std::isfinite(v)) return "–";
  const double size = std::abs(v);
  const int digits = size >= 99.95 ? 0 : size >= 9.995 ? 1 : size >= 0.0995 ? 2 : 3;
  return fmt::format("{:.{}f}", v, digits);
}

std::string percent_around(const Interval& v) {
  if (!std::isfinite(v.low) || !std::isfinite(v.high) || v.low <= 0) return "";
  const double percent = 100 * (std::sqrt(v.high / v.low) - 1);
  return fmt::format("±{:.{}f} %", percent, percent < 9.95 ? 1 : 0);
}

std::string range(const Interval& v) {
  if (!std::isfinite(v.low) || !std::isfinite(v.high)) return "–";
  return short_number(v.low) + "–" + short_number(v.high);
}

std::string with_range(const Interval& v) {
  if (!std::isfinite(v.low) || !std::isfinite(v.high)) return short_number(v.value);
  return fmt::format("{} ({})", short_number(v.value), range(v));
}

std::string duration(double seconds) {
  if (!std::isfinite(seconds)) return "–";
  if (seconds < 0.9995e-3) return short_number(seconds * 1e6) + " µs";
  if (seconds < 0.9995) return short_number(seconds * 1e3) + " ms";
  return short_number(seconds) + " s";
}

std::string grouped(std::uint64_t count) {
  std::string text = fmt::format("{}", count);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, 1, ',');
  return text;
}

std::string enumerate(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " and " : ", ";
    text += words[i];
  }
  return text;
}

}  // namespace capcon
