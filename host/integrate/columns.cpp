#include "integrate/columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/format.h"

namespace capcon::integrate {

std::vector<std::size_t> spoken_counts(const Settings& settings) {
  const auto& counts = settings.counts;
  std::vector<std::size_t> result;
  for (const std::uint32_t n : {16u, 64u, 1024u}) {
    const auto found = std::find(counts.begin(), counts.end(), n);
    if (found != counts.end()) result.push_back(static_cast<std::size_t>(found - counts.begin()));
  }
  if (!result.empty()) return result;
  for (const std::size_t i : {std::size_t{0}, counts.size() / 2, counts.size() - 1}) {
    if (result.empty() || i > result.back()) result.push_back(i);
  }
  return result;
}

double whole_seconds(const Cost& cost) {
  return cost.preparation + ready_seconds(cost);
}
double ready_seconds(const Cost& cost) {
  return cost.points + cost.weights + cost.evaluation;
}

std::string rmse_text(const Figure& figure) {
  if (!figure.measured) return "–";
  return figure.exact ? "exact" : scientific(figure.rmse.value);
}

std::string ratio_text(const Interval& ratio) {
  const bool plain = !(ratio.value < 0.0995) && !(ratio.value >= 999.5);
  return plain ? with_range(ratio) : scientific(ratio.value) + " " + percent_around(ratio);
}

std::string slope_text(const Interval& slope) {
  if (std::isnan(slope.value)) return "–";
  std::string text = fmt::format("{}{:.2f}", slope.value < 0 ? "−" : "", std::abs(slope.value));
  if (std::isfinite(slope.high)) text += fmt::format(" ±{:.2f}", slope.high - slope.value);
  return text;
}

std::string bound_name(Bound::Kind kind) {
  switch (kind) {
    case Bound::Kind::three_sigma:
      return "3σ/√n";
    case Bound::Kind::koksma_hlawka:
      return "V·D*";
    case Bound::Kind::second_derivative:
      return "½ME + GF";
    default:
      return "–";
  }
}

std::string bound_text(const Bound& bound) {
  return bound.kind == Bound::Kind::none
             ? "–"
             : fmt::format("{} {}", scientific(bound.mean), bound_name(bound.kind));
}

std::string bound_held_text(const Bound& bound) {
  return bound.kind == Bound::Kind::none
             ? "–"
             : fmt::format("{} of {}", bound.checked - bound.exceeded, bound.checked);
}

}  // namespace capcon::integrate
