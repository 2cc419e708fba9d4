#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "base/file.h"
#include "integrate/columns.h"
#include "integrate/report.h"
#include "sampling/point_file.h"
#include "study/format.h"
#include "study/html.h"
#include "study/report.h"

namespace capcon::integrate {

int style_of(std::string_view estimator) {
  // The first six as in the study. Neighbours in this list differ in marker and colour.
  static constexpr std::array kOrder = {"random",      "jittered", "sobol-xor",  "sobol-owen",
                                        "ccvt",        "capcon",   "importance", "random-areas",
                                        "ccvt-areas",  "fpo",      "fpo-areas",  "lloyd",
                                        "lloyd-areas", "lattice",  "sobol",      "halton"};
  const auto known = std::find(kOrder.begin(), kOrder.end(), estimator);
  return static_cast<int>(known - kOrder.begin()) % 17;  // 16: all others
}

std::string_view extra_style() {
  return R"(
:root{--c8:#00a07a;--c9:#a3195b;--c10:#c9619a;--c11:#5a7d00;--c12:#8fae33;--c13:#4b4fc4;--c14:#d9a441;--c15:#7f8c8d;--c16:#555}
@media (prefers-color-scheme:dark){:root{--c8:#6fe6c3;--c9:#f277ad;--c10:#f7a8cb;--c11:#b7d75a;--c12:#d3e69a;--c13:#a0a4ff;--c14:#f5cf86;--c15:#c3cbcc;--c16:#aaa}}
.s8{--c:var(--c8)}.s9{--c:var(--c9)}.s10{--c:var(--c10)}.s11{--c:var(--c11)}.s12{--c:var(--c12)}.s13{--c:var(--c13)}.s14{--c:var(--c14)}.s15{--c:var(--c15)}.s16{--c:var(--c16)}
th:first-child{text-align:left}
summary{cursor:pointer;color:var(--soft);font-size:.9rem;margin-top:.8rem}
#ratios th,#ratios td{padding:.2rem .32rem}#ratios table{font-size:.8rem}#ratios .interval{font-size:.68rem}#ratios thead th,details thead th{white-space:normal}
details th,details td{padding:.2rem .4rem}details table{font-size:.8rem}
)";
}

std::string methods_section(const Experiment& experiment) {
  const Settings& s = experiment.settings;
  std::string html = "<dl>";
  const auto term = [&](const std::string& name, const std::string& text) {
    html += fmt::format("<dt>{}</dt><dd>{}</dd>", name, text);
  };
  std::set<std::string> methods;
  std::string randomisations;
  for (const std::string& name : s.estimators) {
    const std::string method = find_estimator(name, s.point_files).method;
    if (methods.insert(method).second) {
      randomisations += fmt::format("{}<code>{}</code>: {}", randomisations.empty() ? "" : "; ",
                                    escape(sampler_label(method)), escape(randomisation_of(method)));
    }
  }
  term("Randomisations", fmt::format("{} for every error up to n = {}, above it fewer in proportion; seed "
                                     "{}. In each the family draws the same integrand for "
                                     "all estimators. {}.",
                                     s.randomisations, kFullCount, s.seed, randomisations));
  term("Base sets",
       "What is shifted was made 8 times up to n = 256, fewer times above, at least twice; randomisations "
       "take turns. The intervals speak of "
       "the randomisations of these sets.");
  term("Weights",
       "<code>-areas</code>: areas of the points' Voronoi cells: on the torus for the periodic integrand, "
       "cut off at the square's sides for all "
       "others. <code>importance</code>: 1/(n density). All else: 1/n.");
  term("Intervals",
       "95 %. Trials are cut into 20 groups; Student's t on the groups' MSEs, the jackknife over groups for "
       "ratios and slopes.");
  term("Slope", fmt::format("Least squares through (log n, log RMSE) from n = {} on.", kSlopeFrom));
  term("3σ/√n",
       "σ in closed form. It holds with probability 0.997 for a normal error; the count says in how many "
       "trials it did.");
  term("V·D*",
       "Koksma and Hlawka: V is Hardy and Krause's variation, in closed form, D* the star discrepancy of the "
       "very points of a trial, exact. Checked in "
       "the first 8 trials (2 at the largest n); the mean is drawn.");
  term("½ME + GF",
       "For f twice differentiable on the cells' domain, M and G the largest norms of its second and first "
       "derivatives, E = Σ∫|x − x<sub>i</sub>|² "
       "over the cells V<sub>i</sub>, F = Σ λ<sub>i</sub>|z<sub>i</sub> − x<sub>i</sub>|, z<sub>i</sub> the "
       "centroids: Taylor's formula about "
       "x<sub>i</sub> leaves at most M|x − x<sub>i</sub>|²/2, and its linear term integrates to "
       "λ<sub>i</sub> grad f · (z<sub>i</sub> − "
       "x<sub>i</sub>). The text's bound, energy alone, is the case of centroidal points, F = 0. Checked in "
       "all trials.");
  term("Time",
       "Processor seconds of one thread for one estimate, each part repeated until it can be measured; base "
       "sets: of all threads, once.");
  term("Run", fmt::format("capcon {}, {} on the clock.", version(), duration(experiment.seconds)));
  return html + "</dl>";
}

std::string html_page(const Experiment& experiment, const Analysis& analysis,
                      const std::vector<GeneratorEnergy>& plane, const std::vector<std::string>& findings) {
  const Settings& s = experiment.settings;
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head>{}<title>Numerical integration: error beside "
      "bound</title><style>{}{}</style></head><body>\n"
      "<a class=\"skip\" href=\"#findings\">To the findings</a><header><p class=\"kicker\">capcon "
      "integrate</p>"
      "<h1>Known integrals: every estimator’s error beside its bound</h1><p class=\"small\">{} integrands · "
      "{} estimators · n = {} … {} · {} "
      "randomisations · seed {}</p></header>\n<main>\n",
      page_meta(), report_style(), extra_style(), s.integrands.size(), s.estimators.size(), s.counts.front(),
      s.counts.back(), s.randomisations, s.seed);
  const auto section = [&](const std::string& id, const std::string& title, const std::string& body) {
    html += fmt::format("<section id=\"{}\"><h2>{}</h2>\n{}</section>\n", id, escape(title), body);
  };
  std::string list;
  for (std::size_t k = 0; k < findings.size(); ++k) {
    list += k == 0 ? fmt::format("<p class=\"headline\">{}</p><ul>", escape(findings[k]))
                   : fmt::format("<li>{}</li>", escape(findings[k]));
  }
  section("findings", "What was found", list + "</ul>");
  std::string ratios =
      "<p>Smaller is better; the best of each column is underlined. Integrands from <i>edge-on-disk</i> on "
      "reach the disk through the "
      "concentric map.</p>";
  for (const std::size_t c : spoken_counts(s)) ratios += ratio_table(experiment, analysis, c);
  section("ratios", "Beside random points", ratios);
  section("energy", "The open question: low energy and equal areas", energy_section(plane));
  for (std::size_t i = 0; i < s.integrands.size(); ++i) {
    section(s.integrands[i], find_integrand(s.integrands[i]).title,
            integrand_section(experiment, analysis, i));
  }
  section("methods", "How it was measured", methods_section(experiment));
  return html + "</main>\n" + page_scripts() + "</body></html>\n";
}

}  // namespace capcon::integrate
