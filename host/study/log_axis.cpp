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

/// Round numbers of one decade, as many as the axis has room for.
std::vector<double> plain_mantissas(double decades) {
  if (decades < 0.5) return {1, 1.2, 1.4, 1.6, 1.8, 2, 2.5, 3, 4, 5, 6, 7, 8, 9};
  if (decades < 1.2) return {1, 1.5, 2, 3, 4, 5, 7};
  return {1, 2, 5};
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
  const int lowest = static_cast<int>(std::floor(std::log10(low_)));
  for (int e = lowest; e <= std::ceil(std::log10(high_)); ++e) {
    const double power = std::pow(10.0, e);
    if (style == Style::plain) {
      for (const double mantissa : plain_mantissas(decades))
        add(mantissa * power, fmt::format("{:g}", mantissa * power));
      continue;
    }
    // On a short axis one decade alone would leave it without words.
    const bool short_axis = decades < (style == Style::seconds ? 1.9 : 1.7);
    for (int mantissa = 1; mantissa < 10; ++mantissa) {
      const double value = mantissa * power;
      std::string label;
      if (mantissa == 1 || (short_axis && (mantissa == 2 || mantissa == 5))) {
        label = style == Style::seconds ? whole_duration(value)
                : mantissa == 1         ? power_of_ten(e)
                                        : fmt::format("{}·{}", mantissa, power_of_ten(e));
      }
      add(value, label);
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
