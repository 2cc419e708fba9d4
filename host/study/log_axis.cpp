#include "study/log_axis.h"

#include <fmt/format.h>

#include <cmath>

#include "study/format.h"

namespace capcon {
namespace {

std::string power_of_ten(int exponent) {
  static const char* const kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char c : fmt::format("{}", std::abs(exponent))) text += kDigits[c - '0'];
  return text;
}

std::string whole_duration(double seconds) {
  if (seconds < 0.9995e-3) return fmt::format("{:g} µs", seconds * 1e6);
  return seconds < 0.9995 ? fmt::format("{:g} ms", seconds * 1e3) : fmt::format("{:g} s", seconds);
}

}  // namespace

LogAxis::LogAxis(double low, double high, double start, double end, Style style)
    : low_(low), high_(high), start_(start), end_(end) {
  const double margin = style == Style::counts ? 1.12 : std::max(1.03, std::pow(high / low, 0.03));
  low_ /= margin;
  high_ *= margin;
  if (style == Style::counts) {
    for (double v = std::exp2(std::ceil(std::log2(low_))); v <= high_; v *= 2) add(v, fmt::format("{:g}", v));
    return;
  }
  const double decades = std::log10(high_ / low_);
  for (int e = static_cast<int>(std::floor(std::log10(low_))); e <= std::ceil(std::log10(high_)); ++e) {
    const double power = std::pow(10.0, e);
    for (int mantissa = 1; mantissa < 10; ++mantissa) {
      const double value = mantissa * power;
      // On a short axis one decade alone would leave it without words.
      const bool word = mantissa == 1 || (decades < 1.7 && (mantissa == 2 || mantissa == 5)) ||
                        (decades < 0.6 && mantissa != 7 && mantissa != 9);
      std::string label;
      if (word) {
        label = style == Style::seconds ? whole_duration(value)
                : style == Style::plain ? fmt::format("{:g}", value)
                : mantissa == 1         ? power_of_ten(e)
                                        : fmt::format("{}·{}", mantissa, power_of_ten(e));
      }
      add(value, label);
      if (style == Style::plain && decades < 0.6 && mantissa == 1)
        add(1.5 * power, fmt::format("{:g}", 1.5 * power));
    }
  }
}

void LogAxis::add(double value, std::string label) {
  if (value >= low_ * (1 - 1e-12) && value <= high_ * (1 + 1e-12))
    ticks_.push_back({value, std::move(label)});
}

double LogAxis::place(double value) const {
  return start_ + (end_ - start_) * std::log(value / low_) / std::log(high_ / low_);
}

}  // namespace capcon
