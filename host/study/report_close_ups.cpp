#include <fmt/format.h>

#include "study/chart.h"
#include "study/format.h"
#include "study/html.h"
#include "study/report.h"

namespace capcon {
namespace {

/// The whole picture with the region framed.
std::string overview(const CloseUps& c, const IntegralWords& words) {
  const Image& p = c.picture;
  return fmt::format(
      "<figure class=\"overview\"><div class=\"framed\">{}<svg viewBox=\"0 0 {} {}\" "
      "aria-hidden=\"true\"><rect class=\"halo\" "
      "x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/><rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" "
      "height=\"{}\"/></svg></div><figcaption>{}, {} {}; framed: the region of the "
      "close-ups.</figcaption></figure>",
      embedded_image(p, 1, std::string(words.picture)), p.width, p.height, c.region.x, c.region.y,
      c.region.width, c.region.height, c.region.x, c.region.y, c.region.width, c.region.height, words.picture,
      c.picture_samples, words.counts);
}

std::string view(const Image& image, float exposure, const std::string& alt, const std::string& caption) {
  return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>", embedded_image(image, exposure, alt),
                     caption);
}

}  // namespace

std::string report_close_ups(const StudySettings& settings, const CloseUps& c) {
  std::string html =
      "<div class=\"pictures\">" + overview(c, words_of(settings.integral)) +
      fmt::format(
          "<figure class=\"overview\"><div class=\"framed\">{}</div><figcaption>The framed region, the "
          "reference for the close-ups.</figcaption></figure></div>",
          embedded_image(c.reference, 1, "The framed region, converged"));
  html += report_viewer(settings, c);
  for (const std::uint32_t samples : c.samples) {
    std::string renders = view(c.reference, 1, "The reference", "reference");
    std::string differences = fmt::format("<p class=\"small\">|render − reference| × {:g}</p>", c.exposure);
    for (const CloseUp& v : c.views) {
      if (v.samples != samples) continue;
      const std::string name = svg_marker(sampler_style(v.sampler, settings)) + escape(v.sampler);
      renders += view(v.crop, 1,
                      fmt::format("{} at {} {}", v.sampler, samples, words_of(settings.integral).many), name);
      differences +=
          view(v.difference, c.exposure, fmt::format("Difference of {} from the reference", v.sampler),
               fmt::format("MSE {}<br>FLIP {:.3f}", scientific(v.mse), v.flip));
    }
    html += fmt::format(
        "<h3>{} {}</h3><div class=\"scroll\" role=\"region\" tabindex=\"0\" "
        "aria-label=\"Close-ups at "
        "{} {}\"><div class=\"views\" style=\"--n:{}\">{}{}</div></div>",
        samples, words_of(settings.integral).counts, samples, words_of(settings.integral).many,
        settings.samplers.size() + 1, renders, differences);
  }
  return html +
         fmt::format(
             "<p class=\"small\">Above the render, below it |render − reference| times {:g}, the same for "
             "all of "
             "them, both as sRGB. The region is the one where all samplers together err most at {} {}. "
             "Seed {} of each; MSE and FLIP within the region.</p>",
             c.exposure, c.samples.back(), words_of(settings.integral).many, c.seed);
}

}  // namespace capcon
