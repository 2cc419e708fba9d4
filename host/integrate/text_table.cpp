#include "integrate/text_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "integrate/columns.h"
#include "study/format.h"

namespace capcon::integrate {
namespace {

/// Characters, not bytes, of UTF-8.
std::size_t columns_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

/// Rows under each other, the first column to the left, all others to the right.
std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], columns_of(row[i]));
  }
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string space(widths[i] - columns_of(row[i]), ' ');
      text += i == 0 ? row[i] + space : "  " + space + row[i];
    }
    text += '\n';
  }
  return text;
}

std::string table_of(const Experiment& experiment, const Analysis& analysis, std::size_t integrand) {
  const Settings& s = experiment.settings;
  const std::vector<std::size_t> spoken = spoken_counts(s);
  const std::size_t last = spoken.back();
  std::vector<std::string> head = {"RMSE at n ="};
  for (const std::size_t c : spoken) head.push_back(fmt::format("{}", s.counts[c]));
  for (const char* word : {"slope", "MSE/random's", "MSE/sobol-owen's", "bound", "held", "time"})
    head.emplace_back(word);
  std::vector<std::vector<std::string>> rows = {head};
  for (std::size_t e = 0; e < s.estimators.size(); ++e) {
    const std::size_t at = experiment.index(integrand, e, last);
    const Figure& figure = analysis.figures[at];
    if (!figure.measured) continue;
    std::vector<std::string> row = {s.estimators[e]};
    for (const std::size_t c : spoken)
      row.push_back(rmse_text(analysis.figures[experiment.index(integrand, e, c)]));
    row.push_back(slope_text(analysis.laws[integrand * s.estimators.size() + e].slope));
    row.push_back(ratio_text(figure.beside_random));
    row.push_back(ratio_text(figure.beside_owen));
    row.push_back(bound_text(experiment.samples[at].bound));
    row.push_back(bound_held_text(experiment.samples[at].bound));
    row.push_back(duration(whole_seconds(experiment.costs[at])));
    rows.push_back(std::move(row));
  }
  return aligned(rows);
}

}  // namespace

std::string text_tables(const Experiment& experiment, const Analysis& analysis,
                        const std::vector<std::string>& findings) {
  const Settings& s = experiment.settings;
  std::string text = fmt::format(
      "Root mean squared error over {} randomisations (fewer above n = {}); slopes from n = {} on; ratios, "
      "bounds and processor time at n = {}; "
      "95 % intervals\n\n",
      s.randomisations, kFullCount, kSlopeFrom, s.counts[spoken_counts(s).back()]);
  for (std::size_t i = 0; i < s.integrands.size(); ++i) {
    const Integrand& integrand = find_integrand(s.integrands[i]);
    text += fmt::format("{}: {}\n{}\n", integrand.name, integrand.formula, table_of(experiment, analysis, i));
  }
  for (const std::string& finding : findings) text += finding + '\n';
  return text;
}

}  // namespace capcon::integrate
