#pragma once

#include <string>

#include "integrate/analysis.h"

namespace capcon::integrate {

/// The numbers of points that tables and sentences speak of: those of 16, 64, 1024 that were measured, else
/// the smallest, the middle and the largest. Indices into Settings::counts.
std::vector<std::size_t> spoken_counts(const Settings& settings);

/// Whole processor seconds of one estimate from nothing, and with the base set or tile set at hand.
double whole_seconds(const Cost& cost);
double ready_seconds(const Cost& cost);

// Figures as words; "–" where there is none.
std::string rmse_text(const Figure& figure);      ///< "2.97e-3", "exact"
std::string ratio_text(const Interval& ratio);    ///< "0.81 (0.79–0.83)", "3.2e-4 ±8 %"
std::string slope_text(const Interval& slope);    ///< "−0.75 ±0.02"
std::string bound_text(const Bound& bound);       ///< "8.1e-2 KH"
std::string bound_held_text(const Bound& bound);  ///< "997 of 1000"
std::string bound_name(Bound::Kind kind);         ///< "3σ/√n", "V·D*", "½ME + GF"

}  // namespace capcon::integrate
