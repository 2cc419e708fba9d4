#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "study/chart.h"
#include "study/findings.h"
#include "study/format.h"
#include "study/html.h"
#include "study/overlay.h"
#include "study/report.h"

namespace capcon {
namespace {

const StudySettings& settings_of(const Overlay& o) {
  return o.studies.front().result.settings;
}

std::string chart(const Overlay& o, Chart chart, const std::function<Interval(const Cell&)>& x,
                  const std::string& caption) {
  chart.name_room = 190;
  for (const std::string& sampler : o.samplers) {
    for (std::size_t i = 0; i < o.studies.size(); ++i) {
      const Curve* curve = o.figures[i].curve(sampler);
      ChartLine line{fmt::format("{} @ {}", sampler, o.labels[i]),
                     sampler_style(sampler, settings_of(o)),
                     false,
                     {},
                     {},
                     static_cast<int>(i)};
      for (const Cell& cell : curve->cells) {
        if (cell.mse.value <= 0) continue;
        line.points.push_back({x(cell), cell.mse, cell.sure,
                               fmt::format("{} at {}: MSE {} {}, {} on the device", line.name, cell.samples,
                                           scientific(cell.mse.value), percent_around(cell.mse),
                                           duration(cell.device_seconds.value))});
      }
      chart.lines.push_back(std::move(line));
    }
  }
  return chart_figure(chart, caption);
}

std::string charts(const Overlay& o) {
  const IntegralWords& words = words_of(settings_of(o).integral);
  const std::string dashes = "A colour is a sampler, a kind of line a study: " + escape(enumerate(o.labels)) +
                             ". Bars: 95 % intervals over the seeds.";
  std::string html = "<div class=\"charts\">";
  html += chart(
      o,
      {"c-samples",
       fmt::format("Error against {}", words.many),
       "Mean squared error, one line a sampler and study.",
       std::string(words.counts),
       "MSE",
       LogAxis::Style::counts,
       LogAxis::Style::decades,
       false,
       {}},
      [](const Cell& c) {
        return Interval{static_cast<double>(c.samples), NAN, NAN};
      },
      dashes);
  html += chart(
      o,
      {"c-device",
       "Error against device time",
       "Mean squared error, one line a sampler and study.",
       "device time of a render",
       "MSE",
       LogAxis::Style::seconds,
       LogAxis::Style::decades,
       false,
       {}},
      [](const Cell& c) { return c.device_seconds; }, dashes);
  return html + "</div>";
}

/// A line for each count and a column for each sampler, of one study beside the first.
std::string ratio_table(const Overlay& o, const Beside& b, const std::string& caption,
                        const std::function<Interval(const Ratio&)>& figure, const Csv& csv,
                        const std::string& file) {
  std::vector<std::string> head = {std::string(words_of(settings_of(o).integral).many)};
  for (const std::string& sampler : o.samplers)
    head.push_back(svg_marker(sampler_style(sampler, settings_of(o))) + escape(sampler));
  HtmlTable table(caption, head);
  for (const std::uint32_t n : o.samples) {
    std::vector<std::string> row = {count_label(settings_of(o), n)};
    for (const std::string& sampler : o.samplers) {
      const Ratio* r = o.ratio(b, sampler, n);
      const Interval v = r ? figure(*r) : Interval{NAN, NAN, NAN};
      row.push_back(std::isnan(v.value)
                        ? "<span class=\"none\">–</span>"
                        : fmt::format("<span class=\"figure {}\">{}</span><span class=\"interval\">{}</span>",
                                      v.below(1)   ? "better"
                                      : v.above(1) ? "worse"
                                                   : "",
                                      short_number(v.value), range(v)));
    }
    table.row(row);
  }
  table.csv(csv, file);
  return table.str();
}

Csv ratios_csv(const Overlay& o, const Beside& b) {
  Csv csv(
      "study,beside,sampler,samples,mse_ratio,mse_ratio_low,mse_ratio_high,equal_error_samples,"
      "equal_error_samples_low,equal_error_samples_high,equal_error_time_ratio,equal_error_time_ratio_low,"
      "equal_error_time_ratio_high,equal_time_mse_ratio,equal_time_mse_ratio_low,equal_time_mse_ratio_high");
  for (const Ratio& r : b.ratios) {
    csv.add(o.labels[b.study]).add(o.labels[0]).add(r.sampler).add(r.samples).add(r.mse).add(r.equal_error);
    csv.add(r.equal_error_time).add(r.equal_time).end_row();
  }
  return csv;
}

std::string tables(const Overlay& o) {
  const std::string many(words_of(settings_of(o).integral).many);
  std::string html =
      "<p class=\"small\"><span class=\"better\">▼ less</span> and <span class=\"worse\">▲ more</span> mark "
      "differences "
      "that the 95 % interval shows. – : never reached by one of the two, or not sure.</p>";
  for (const Beside& b : o.beside) {
    const std::string pair = fmt::format("{} beside {}", o.labels[b.study], o.labels[0]);
    const Csv csv = ratios_csv(o, b);
    const std::string file = fmt::format("{}-beside-{}.csv", o.labels[b.study], o.labels[0]);
    html += fmt::format("<h3>{}</h3><div class=\"pair\">", escape(pair));
    html += ratio_table(
        o, b, fmt::format("Device time for equal error: {}, at the error of so many {}", pair, many),
        [](const Ratio& r) { return r.equal_error_time; }, csv, file);
    if (b.same_errors) {
      html += fmt::format("</div><p>With as many {} the errors of both are the same, bit by bit.</p>", many);
      continue;
    }
    html += ratio_table(
        o, b, fmt::format("{} for equal error, over those of the first", many),
        [](const Ratio& r) {
          const double n = r.samples;
          return Interval{r.equal_error.value / n, r.equal_error.low / n, r.equal_error.high / n};
        },
        csv, file);
    html += "</div>" + ratio_table(
                           o, b, fmt::format("MSE with as many {}: {}", many, pair),
                           [](const Ratio& r) { return r.mse; }, csv, file);
  }
  return html;
}

std::string what_differs(const Overlay& o) {
  std::vector<std::string> head = {""};
  for (const std::string& label : o.labels) head.push_back(escape(label));
  HtmlTable table("What differs between these studies", head);
  for (const Difference& d : differences(o)) {
    std::vector<std::string> row = {escape(d.name)};
    for (const std::string& v : d.values) row.push_back("<span class=\"text\">" + escape(v) + "</span>");
    table.row(row);
  }
  return table.str();
}

std::string methods(const Overlay& o) {
  return fmt::format(
      "<dl><dt>samples for equal error</dt><dd>how many the sampler needs in one study for the MSE that it "
      "has with n in "
      "the first, read off its curve (straight in log-log, never extrapolated), over n.</dd>"
      "<dt>device time for equal error</dt><dd>device time at that MSE, read off its curve of time over MSE, "
      "over the "
      "device time of n in the first.</dd>"
      "<dt>MSE</dt><dd>of one run: mean over pixels of (I − R̄)² less the expected squared error of that "
      "study’s own "
      "reference R̄; geometric mean over seeds.</dd>"
      "<dt>intervals</dt><dd>95 %, by the jackknife over the {} seeds that all of these studies have, the "
      "same seeds "
      "in both of a pair, on logarithms.</dd>"
      "<dt>each study</dt><dd>has a report of its own in its folder: what ran, what was left out, every "
      "run.</dd></dl>",
      o.seeds);
}

}  // namespace

std::string html_report(const Overlay& o) {
  const StudySettings& s = settings_of(o);
  const std::vector<std::string> findings = make_findings(o);
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head>{}<title>{}: {} studies</title>"
      "<style>{}#differs td{{white-space:normal;text-align:left}}#differs "
      "th{{text-align:left}}</style></head><body>\n"
      "<a class=\"skip\" href=\"#charts\">To the charts</a>"
      "<header><p class=\"kicker\">capcon report · {}</p><h1>{}</h1>"
      "<p class=\"small\">{} · {} × {} pixels · {} seeds</p></header>\n<main>\n",
      page_meta(), words_of(s.integral).title, o.studies.size(), report_style(), words_of(s.integral).title,
      escape(enumerate(o.labels)), escape(s.scene), s.width, s.height, o.seeds);
  const auto section = [&](const char* id, const std::string& title, const std::string& body) {
    html += fmt::format("<section id=\"{}\"><h2>{}</h2>\n{}</section>\n", id, title, body);
  };
  std::string list;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    list += i == 0 ? fmt::format("<p class=\"headline\">{}</p><ul>", escape(findings[0]))
                   : fmt::format("<li>{}</li>", escape(findings[i]));
  }
  section("findings", "What was found", list + "</ul>");
  section("charts", "Error against samples and time", charts(o));
  section("tables", "Equal error", tables(o));
  section("differs", "What differs", what_differs(o));
  section("methods", "How each figure is computed",
          methods(o) +
              "<p class=\"data\"><button type=\"button\" hidden data-download=\"study-json\" "
              "data-type=\"application/json\" data-name=\"overlay.json\">every figure as JSON</button></p>");
  return html + "</main>\n" + data_script("type=\"application/json\" id=\"study-json\"", to_json(o).dump()) +
         page_scripts() + "</body></html>\n";
}

}  // namespace capcon
