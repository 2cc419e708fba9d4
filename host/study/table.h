#pragma once

#include <string>

#include "study/figures.h"

namespace capcon {

/// The study's figures for a terminal: MSE with 95 % intervals, slopes, equal-error and equal-time ratios,
/// findings.
std::string text_tables(const StudyResult& result, const Figures& figures);

}  // namespace capcon
