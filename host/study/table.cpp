#include "study/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>

#include "study/coarse.h"
#include "study/findings.h"
#include "study/format.h"

namespace capcon {
namespace {

/// Rows of cells, each column as wide as its widest; first column and all others right-aligned.
class Grid {
 public:
  void row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  std::string str() const {
    std::vector<std::size_t> widths;
    for (const auto& row : rows_) {
      if (widths.size() < row.size()) widths.resize(row.size());
      for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], columns(row[i]));
    }
    std::string text;
    for (const auto& row : rows_) {
      for (std::size_t i = 0; i < row.size(); ++i) {
        text += (i == 0 ? "" : "  ") + std::string(widths[i] - columns(row[i]), ' ') + row[i];
      }
      text += '\n';
    }
    return text;
  }

 private:
  /// Characters, not bytes, of UTF-8.
  static std::size_t columns(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
  }
  std::vector<std::vector<std::string>> rows_;
};

std::string mse_table(const StudyResult& result, const Figures& figures) {
  Grid grid;
  std::vector<std::string> head = {std::string(words_of(result.settings.integral).many)};
  for (const Curve& curve : figures.curves) head.push_back(curve.sampler);
  grid.row(head);
  for (const std::uint32_t n : result.settings.samples) {
    std::vector<std::string> row = {count_label(result.settings, n)};
    for (const Curve& curve : figures.curves) {
      const Cell* cell = find_cell(curve, n);
      row.push_back(!cell        ? "–"
                    : cell->sure ? scientific(cell->mse.value) + " " + percent_around(cell->mse)
                                 : "unsure");
    }
    grid.row(row);
  }
  if (result.settings.integral == Integral::splitting) return grid.str();
  std::vector<std::string> slopes = {"slope"};
  for (const Curve& curve : figures.curves) {
    const Interval& v = curve.slope;
    slopes.push_back(std::isnan(v.value)  ? "–"
                     : std::isnan(v.high) ? fmt::format("{:.3f}", v.value)
                                          : fmt::format("{:.3f} ±{:.3f}", v.value, v.high - v.value));
  }
  grid.row(slopes);
  return grid.str();
}

std::string ratio_table(const StudyResult& result, const Figures& figures, const std::string& baseline,
                        bool time) {
  Grid grid;
  std::vector<std::string> head = {baseline};
  for (const Curve& curve : figures.curves) {
    if (curve.sampler != baseline) head.push_back(curve.sampler);
  }
  grid.row(head);
  for (const std::uint32_t n : result.settings.samples) {
    std::vector<std::string> row = {count_label(result.settings, n)};
    for (const Curve& curve : figures.curves) {
      if (curve.sampler == baseline) continue;
      const Ratio* r = figures.ratio(curve.sampler, baseline, n);
      if (!r) {
        row.push_back("–");
      } else if (time) {
        row.push_back(with_range(r->equal_time));
      } else if (r->beyond != 0) {
        row.push_back(r->beyond < 0 ? fmt::format("< {}", result.settings.samples.front())
                                    : fmt::format("> {}", result.settings.samples.back()));
      } else {
        row.push_back(with_range(r->equal_error));
      }
    }
    grid.row(row);
  }
  return grid.str();
}

/// A figure of every cell of noise.
std::string noise_grid(const StudyResult& result, const Noise& noise,
                       const std::function<std::string(const NoiseCell&)>& figure) {
  Grid grid;
  std::vector<std::string> head = {std::string(words_of(result.settings.integral).many)};
  head.insert(head.end(), result.settings.samplers.begin(), result.settings.samplers.end());
  grid.row(head);
  for (const std::uint32_t n : result.settings.samples) {
    std::vector<std::string> row = {count_label(result.settings, n)};
    for (const std::string& sampler : result.settings.samplers) {
      const NoiseCell* cell = noise.cell(sampler, n);
      row.push_back(cell ? figure(*cell) : "–");
    }
    grid.row(row);
  }
  return grid.str();
}

std::string noise_tables(const StudyResult& result, const Noise& noise) {
  return fmt::format(
             "Standard deviation over seeds; error of their mean / what chance alone makes of it (root mean "
             "squares)\n\n{}\n",
             noise_grid(result, noise,
                        [](const NoiseCell& c) {
                          return fmt::format("{}; {} / {}", scientific(c.deviation.value),
                                             scientific(c.mean_error), scientific(c.chance));
                        })) +
         fmt::format(
             "Share of the squared error that a box filter of {} x {} pixels leaves; {} of independent "
             "errors\n\n{}\n",
             kCoarseBlock, kCoarseBlock, short_number(noise.coarse_by_chance),
             noise_grid(result, noise, [](const NoiseCell& c) { return with_range(c.coarse); }));
}

}  // namespace

std::string text_tables(const StudyResult& result, const Figures& figures) {
  std::string text = fmt::format(
      "Mean squared error and 95 % interval over {} seed{}; the reference's own error, {}, is taken "
      "off\n\n{}\n",
      result.settings.seeds, result.settings.seeds == 1 ? "" : "s", scientific(figures.reference_error),
      mse_table(result, figures));
  const bool counts_work = result.settings.integral != Integral::splitting;  // all splits are the same work
  const std::vector<std::string> baselines = counts_work ? figures.baselines : std::vector<std::string>();
  std::string units(words_of(result.settings.integral).many);
  units[0] = static_cast<char>(std::toupper(units[0]));
  for (const std::string& baseline : baselines) {
    text += fmt::format("{} needed for the error of {}\n\n{}\n", units, baseline,
                        ratio_table(result, figures, baseline, false));
  }
  for (const std::string& baseline : baselines) {
    text +=
        fmt::format("Error beside {}'s, in the device seconds that its {} take\n\n{}\n", baseline,
                    words_of(result.settings.integral).many, ratio_table(result, figures, baseline, true));
  }
  if (!figures.clocks.empty()) text += figures.clocks + "\n\n";
  if (!figures.noise.cells.empty()) text += noise_tables(result, figures.noise);
  for (const std::string& finding : make_findings(result.settings, figures)) text += finding + '\n';
  return text;
}

}  // namespace capcon
