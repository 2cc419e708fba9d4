#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "study/clocks.h"
#include "study/coarse.h"
#include "study/format.h"
#include "study/html.h"
#include "study/report.h"

namespace capcon {
namespace {

std::string what_ran(const StudyResult& result, const Figures& figures) {
  const StudySettings& s = result.settings;
  std::string html = "<h3>What ran</h3><dl>";
  const auto item = [&](const std::string& name, const std::string& value) {
    html += fmt::format("<dt>{}</dt><dd>{}</dd>", escape(name), escape(value));
  };
  item("scene", fmt::format("{}: {} triangles, {} with instances", s.scene, grouped(s.unique_triangles),
                            grouped(s.instanced_triangles)));
  item("image",
       fmt::format("{} × {} pixels, image samples {}", s.width, s.height,
                   s.position == PixelPosition::centre ? "at pixel centres" : "at points of the sampler"));
  if (s.integral == Integral::ambient_occlusion)
    item("radius", std::isfinite(s.radius) ? fmt::format("{:g} scene units", s.radius) : "unlimited");
  if (s.integral == Integral::splitting)
    item("points a pixel", fmt::format("{} for each light and the BSDF", s.combined));
  if (s.integral == Integral::global_illumination) {
    item("light paths", fmt::format("{} a set; what a sampler makes is these alone", s.paths));
    const std::string limit = s.limit > 0 ? fmt::format("{:g}", s.limit) : "the limit by the scene's size";
    const std::string rest =
        s.clamping == Clamping::compensate
            ? fmt::format("at most {}; the rest by {} compensation rays a set, of {} for all samplers", limit,
                          kGatherRays, kReferenceSampler)
        : s.clamping == Clamping::clamp ? fmt::format("at most {}, in the reference too", limit)
                                        : "not limited";
    item("geometry term", rest);
  }
  item("runs", fmt::format("{} samplers × {} counts × {} seeds (1 … {}) = {} renders", s.samplers.size(),
                           s.samples.size(), s.seeds, s.seeds, result.records.size()));
  item("reference",
       fmt::format("{}, {} groups of {} {}; its own expected MSE {}", kReferenceSampler, s.reference_groups,
                   s.reference_samples, words_of(s.integral).many, scientific(figures.reference_error)));
  for (const auto& [name, value] : result.device.items()) {
    item("device " + name, value.is_string() ? value.get<std::string>() : value.dump());
  }
  if (const Clocks clocks(result); clocks.several()) {
    item("times", clocks.sentence());
    for (const Clock& clock : clocks.all()) {
      item(clock.process.empty() ? "one process" : "process " + clock.process,
           fmt::format("{} renders on {}; calibration {}; times multiplied by {:.3f}", clock.runs,
                       clock.device, duration(clock.calibration_seconds), clock.factor));
    }
  }
  item("first measured", result.started);
  item("program", "capcon " + result.version);
  html += fmt::format("<dt>command</dt><dd><code>{}</code></dd></dl>", escape(s.command));
  return html;
}

constexpr std::string_view kFormulas = R"(<h3>How each figure is computed</h3>
<dl>
<dt>reference</dt><dd>G independent groups of R samples each; the image is their mean R̄. Its expected squared error is
e = mean over pixels of s² / G, with s² a pixel's sample variance over the groups.</dd>
<dt>MSE</dt><dd>of one run: mean over all pixels of (I − R̄)², less e: the expectation of (I − R̄)² is the true MSE plus e. Over seeds:
the geometric mean, with a Student t interval on the logarithms. An MSE below 3 e is marked unsure and enters no comparison.</dd>
<dt>relMSE</dt><dd>mean over pixels of (I − R̄)² / (R̄² + 0.01), R̄ the reference: dark pixels count as much as bright ones. Over seeds as the
MSE, but nothing is taken off.</dd>
<dt>FLIP</dt><dd>of Andersson et al. (2020): how different two images look when one flips between them, from 0 to 1, of values clamped to [0, 1] as the
pictures here show them (exposure 1, sRGB), at 67.0 pixels per degree (3840 pixels on 0.7 m, seen from 0.7 m). Both are blurred in an opponent colour
space as the eye blurs, by Gaussians of its contrast sensitivities; colours differ by ΔE<sub>c</sub>, a power 0.7 of the distance |ΔL| + |Δ(a, b)| of
CIELAB with chroma times L / 100, mapped to [0, 1]; edges and points, by first and second derivatives of a Gaussian of 0.041 degrees, differ by
ΔE<sub>f</sub> = max(|Δedge|, |Δpoint|) / √2 to the power 0.5. A pixel has ΔE<sub>c</sub> to the power 1 − ΔE<sub>f</sub>; given is the mean over pixels, and
the arithmetic mean over seeds.</dd>
<dt>intervals</dt><dd>95 %, over seeds. Means: Student t with (seeds − 1) degrees of freedom. Slopes and ratios: the jackknife over seeds
with the same quantile, on logarithms for ratios. They speak of the samplers' randomness on this scene, and of the machine's jitter
where time enters; not of other scenes.</dd>
<dt>slope</dt><dd>least-squares line through (log samples, log MSE), from 4 samples on; over device time likewise.</dd>
<dt>equal error</dt><dd>the number of samples m at which the sampler's curve, straight between its points in log-log, reaches the
baseline's MSE at n samples. Never extrapolated: “&lt;” or “&gt;” where the curve ends before.</dd>
<dt>time for equal error</dt><dd>device time of the sampler at the baseline's MSE at n samples, read off its curve of time over MSE (straight in
log-log), over that of the baseline's n samples.</dd>
<dt>equal time</dt><dd>MSE of the sampler, read off its curve over device time (straight in log-log) at the device seconds of the
baseline's n samples, divided by the baseline's MSE.</dd>
<dt>device time</dt><dd>sum over the stages of a render of the device's own timestamps; geometric mean over seeds. On a CPU device such
as lavapipe these are the time of its queue thread. The reference path, which has no such clock, gives seconds on the clock.</dd>
<dt>whole time</dt><dd>seconds on the clock from job to image: making and uploading points, rendering, reading back; not reading the
scene, building its tree or compiling kernels, which happen once.</dd>
<dt>order of runs</dt><dd>seed by seed, within it sample count by sample count, within it all samplers in an order shuffled by hash: a machine
that slows down does so for all samplers alike.</dd>
</dl>
<p class="small">Beside this page: runs.jsonl (every run), study.json (every figure), reference.exr (the reference image), close-ups/ (its images).
<code>capcon report</code> makes it anew from them, and lays several studies over each other.</p>)";

/// Every run as it was measured.
std::string raw_data(const StudyResult& result) {
  Csv csv(
      "sampler,samples,seed,mse,mse_trimmed,relmse,flip,mse_coarse,rays,device_seconds,wall_seconds,"
      "point_generation_seconds,device,process");
  for (const RunRecord& r : result.records) {
    csv.add(r.run.sampler).add(r.run.samples).add(r.run.seed).add(r.mse).add(r.mse_trimmed).add(r.relmse);
    csv.add(r.flip >= 0 ? r.flip : NAN)
        .add(r.mse_coarse)
        .add(static_cast<double>(r.rays))
        .add(r.device_seconds);
    csv.add(r.wall_seconds).add(r.point_generation_seconds).add(r.device).add(r.process).end_row();
  }
  constexpr std::size_t kMost = 500'000;  // bytes: pages stay small, and the file lies beside them
  const std::string runs =
      csv.text().size() > kMost
          ? fmt::format("the {} runs are in runs.jsonl beside it", grouped(result.records.size()))
          : fmt::format("every run as {}, errors as measured (the reference’s own, {}, not taken off)",
                        csv.link("runs.csv", "every run"), scientific(result.reference.error));
  return fmt::format(
      "<p class=\"data\">This page holds its data: {}<button type=\"button\" hidden "
      "data-download=\"study-json\" "
      "data-type=\"application/json\" data-name=\"study.json\">every figure as JSON</button></p>",
      runs);
}

std::string noise_formulas(double coarse_error) {
  return fmt::format(
      R"(<dt>noise</dt><dd>of a pixel: s², the sample variance over the seeds; given is the root of its mean over pixels and channels.</dd>
<dt>mean error</dt><dd>root mean square of (mean over n seeds − R̄). Without bias its square is the mean of s² / n plus e in expectation:
that is "chance". What is left of the square without chance estimates the mean square of a bias. Errors of pixels go together, so it moves
more than so many pixels suggest: its interval, by the jackknife over seeds, says how much.</dd>
<dt>coarse error</dt><dd>mean square, over blocks of {0} × {0} pixels weighted by their pixels, of the mean of I − R̄ in a block, less that of the
reference ({1}); its share of the MSE is the ratio of the means over seeds.</dd>
)",
      kCoarseBlock, scientific(coarse_error));
}

}  // namespace

std::string report_methods(const StudyResult& result, const Figures& figures) {
  std::string formulas(kFormulas);
  const std::string integral =
      fmt::format("<dt>the integral</dt><dd>{}</dd>\n", words_of(result.settings.integral).formula);
  formulas.insert(formulas.find("<dt>reference</dt>"), integral);
  if (keeps_images(result.settings.integral))
    formulas.insert(formulas.find("<dt>device time</dt>"), noise_formulas(result.reference.coarse_error));
  return what_ran(result, figures) + raw_data(result) + formulas;
}

}  // namespace capcon
