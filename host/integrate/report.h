#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "integrate/analysis.h"
#include "integrate/energy_plane.h"

namespace capcon::integrate {

struct Report {
  std::string text;  ///< tables for a terminal
  std::string page;  ///< one HTML file that loads nothing else and runs no scripts
  nlohmann::ordered_json json;
};

/// Runs the experiment and measures the generators, and says what came of it.
Report make_report(const Settings& settings);

// Its parts.

nlohmann::ordered_json to_json(const Experiment& experiment, const Analysis& analysis,
                               const std::vector<GeneratorEnergy>& plane);
std::string html_page(const Experiment& experiment, const Analysis& analysis,
                      const std::vector<GeneratorEnergy>& plane, const std::vector<std::string>& findings);
/// A section an integrand: its two charts and its table.
std::string integrand_section(const Experiment& experiment, const Analysis& analysis, std::size_t integrand);
/// MSE beside that of random points, integrands down, estimators across, at one count.
std::string ratio_table(const Experiment& experiment, const Analysis& analysis, std::size_t count);
std::string energy_section(const std::vector<GeneratorEnergy>& plane);
std::string methods_section(const Experiment& experiment);
/// Marker and colour of an estimator: those of the study where it has them.
int style_of(std::string_view estimator);
/// What the study's style sheet lacks.
std::string_view extra_style();

}  // namespace capcon::integrate
