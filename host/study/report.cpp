#include "study/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "sampling/sampler.h"
#include "study/chart.h"
#include "study/findings.h"
#include "study/format.h"
#include "study/html.h"

namespace capcon {

int sampler_style(const std::string& sampler, const StudySettings& settings) {
  static constexpr std::array kKnown = {"random", "jittered", "sobol-xor",    "sobol-owen",
                                        "ccvt",   "capcon",   "capcon-domain"};
  const auto known = std::find(kKnown.begin(), kKnown.end(), sampler);
  if (known != kKnown.end()) return static_cast<int>(known - kKnown.begin());
  constexpr int kStyles = 8;
  std::vector<int> left;
  for (int i = 0; i < kStyles; ++i) {
    const int style = (static_cast<int>(kKnown.size()) + i) % kStyles;
    const bool taken = style < static_cast<int>(kKnown.size()) &&
                       std::find(settings.samplers.begin(), settings.samplers.end(), kKnown[style]) !=
                           settings.samplers.end();
    if (!taken) left.push_back(style);
  }
  std::size_t others = 0;
  for (const std::string& name : settings.samplers) {
    if (name == sampler) break;
    if (std::find(kKnown.begin(), kKnown.end(), name) == kKnown.end()) ++others;
  }
  return left.empty() ? static_cast<int>(others % kStyles) : left[others % left.size()];
}

namespace {

std::string findings_section(const StudyResult& result, const Figures& figures) {
  const std::vector<std::string> findings = make_findings(result.settings, figures);
  std::string html = fmt::format("<p class=\"headline\">{}</p><ul>", escape(findings.front()));
  for (std::size_t i = 1; i < findings.size(); ++i) html += fmt::format("<li>{}</li>", escape(findings[i]));
  return html +
         "</ul><p class=\"small\">In parentheses: 95 % confidence intervals over the seeds. A difference is "
         "called one "
         "where its interval excludes no difference; of every twenty such calls about one is chance.</p>";
}

}  // namespace

std::string html_report(const StudyResult& result, const Figures& figures,
                        const std::optional<CloseUps>& close_ups,
                        const std::optional<Explanation>& explanation) {
  const StudySettings& s = result.settings;
  const std::string device = result.device.value("name", "unknown device");
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head>{}<title>{}: error against run "
      "time</title>"
      "<style>{}</style></head><body>\n<a class=\"skip\" href=\"#charts\">To the charts</a>"
      "<header><p class=\"kicker\">capcon study · {}</p><h1>Error against run time, sampler "
      "by sampler</h1>"
      "<p class=\"small\">{} · {} × {} pixels · {} instanced triangles · {} · {}</p></header>\n<main>\n",
      page_meta(), words_of(s.integral).title, report_style(), words_of(s.integral).title, escape(s.scene),
      s.width, s.height, grouped(s.instanced_triangles), escape(device), escape(result.started));
  const auto section = [&](const char* id, const std::string& title, const std::string& body) {
    html += fmt::format("<section id=\"{}\"><h2>{}</h2>\n{}</section>\n", id, title, body);
  };
  section("findings", "What was found", findings_section(result, figures));
  if (!figures.clocks.empty()) html += fmt::format("<p class=\"small\">{}</p>\n", escape(figures.clocks));
  section("charts", fmt::format("Error against {} and against time", words_of(s.integral).many),
          report_charts(result, figures));
  if (close_ups) section("close-ups", "What it looks like", report_close_ups(s, *close_ups));
  if (!figures.noise.cells.empty())
    section("noise", "Noise against structure", report_noise(result, figures));
  section("tables", "The figures", report_tables(result, figures));
  if (explanation) section("left-out", "What was left out", report_explanation(s, *explanation));
  section("methods", "What ran, and how each figure is computed", report_methods(result, figures));
  nlohmann::json json = to_json(result, figures);
  if (explanation) json["explanation"] = to_json(*explanation);
  return html + "</main>\n" + data_script("type=\"application/json\" id=\"study-json\"", json.dump()) +
         page_scripts() + "</body></html>\n";
}

}  // namespace capcon
