#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "study/chart.h"
#include "study/coarse.h"
#include "study/format.h"
#include "study/html.h"
#include "study/report.h"

namespace capcon {
namespace {

using Figure = std::function<std::string(const NoiseCell&)>;

std::string cell(const std::string& value, const std::string& small) {
  return fmt::format("<span class=\"figure\">{}</span><span class=\"interval\">{}</span>", value, small);
}

std::string table(const StudyResult& result, const Noise& noise, const std::string& caption,
                  const Figure& figure) {
  const StudySettings& s = result.settings;
  std::vector<std::string> head = {std::string(words_of(s.integral).many)};
  for (const std::string& sampler : s.samplers)
    head.push_back(svg_marker(sampler_style(sampler, s)) + escape(sampler));
  HtmlTable html(caption, head);
  for (const std::uint32_t n : s.samples) {
    std::vector<std::string> row = {count_label(s, n)};
    for (const std::string& sampler : s.samplers) {
      const NoiseCell* c = noise.cell(sampler, n);
      row.push_back(c ? figure(*c) : "<span class=\"none\">–</span>");
    }
    html.row(row);
  }
  return html.str();
}

/// The hundredth largest of all values becomes white.
float common_exposure(const std::vector<NoiseMap>& maps) {
  std::vector<float> all;
  for (const NoiseMap& map : maps) {
    all.insert(all.end(), map.deviation.pixels.begin(), map.deviation.pixels.end());
    all.insert(all.end(), map.mean_error.pixels.begin(), map.mean_error.pixels.end());
  }
  const auto place = all.begin() + static_cast<std::ptrdiff_t>(all.size() - 1 - all.size() / 100);
  std::nth_element(all.begin(), place, all.end());
  return *place > 0 ? std::max(0.1f, std::round(10 / *place) / 10) : 1;
}

std::string map_figure(const Image& map, float exposure, const std::string& alt, const std::string& caption) {
  return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>", embedded_image(map, exposure, alt),
                     caption);
}

std::string maps_section(const StudyResult& result, const Noise& noise) {
  if (noise.maps.empty()) return {};
  const std::string_view counts = words_of(result.settings.integral).counts;
  const float exposure = common_exposure(noise.maps);
  std::string deviations, errors;
  for (const NoiseMap& map : noise.maps) {
    const std::string name = svg_marker(sampler_style(map.sampler, result.settings)) + escape(map.sampler);
    deviations += map_figure(map.deviation, exposure, "Standard deviation over seeds of " + map.sampler,
                             name + ": standard deviation");
    errors += map_figure(map.mean_error, exposure, "Error of the mean over seeds of " + map.sampler,
                         name + ": error of the mean");
  }
  return fmt::format(
      "<h3>Where noise and mean error lie, at {} {}</h3><div class=\"scroll\" role=\"region\" tabindex=\"0\" "
      "aria-label=\"Maps of noise and mean error\"><div class=\"views\" style=\"--n:{}\">{}{}</div></div>"
      "<p class=\"small\">Each pixel over the seeds 1 … {}, root mean square of its channels, times {:g}, "
      "the same "
      "for all, as sRGB. Above: how much it differs from seed to seed. Below: how far the mean over the "
      "seeds is "
      "from the reference; by chance alone that is 1/√{} of the map above it.</p>",
      noise.map_samples, counts, noise.maps.size(), deviations, errors, noise.seeds, exposure, noise.seeds);
}

}  // namespace

std::string report_noise(const StudyResult& result, const Figures& figures) {
  const Noise& noise = figures.noise;
  const std::string question = fmt::format(
      "<p>All pixels see the same light paths, so an error is not only noise from pixel to pixel: it is "
      "blotches, "
      "spots and false shadows of single virtual lights. Two questions are asked of it. Does the mean over "
      "seeds "
      "come to the reference, or is a part of the error always there? And how much of an image's error is "
      "coarse, "
      "so that it survives a box filter of {} × {} pixels?</p>",
      kCoarseBlock, kCoarseBlock);
  const std::string deviations = table(
      result, noise,
      fmt::format("Standard deviation of a pixel over {} seeds; below it the error of their mean, and what "
                  "chance alone makes of that",
                  noise.seeds),
      [](const NoiseCell& c) {
        return cell(
            scientific(c.deviation.value) + " " + percent_around(c.deviation),
            fmt::format("mean {}</span><span class=\"interval\">chance {}{}", scientific(c.mean_error),
                        scientific(c.chance), c.bias_square.above(0) ? " <strong>more</strong>" : ""));
      });
  const std::string note =
      "<p class=\"small\">All are root mean squares over pixels. <strong>more</strong>: the interval of what "
      "is "
      "left of the mean's squared error without chance excludes nothing.</p>";
  const std::string shares =
      table(result, noise,
            fmt::format(
                "Share of the squared error that a box filter of {} × {} pixels leaves, with 95 % interval; "
                "of errors independent from pixel to pixel: {}",
                kCoarseBlock, kCoarseBlock, short_number(noise.coarse_by_chance)),
            [](const NoiseCell& c) { return cell(short_number(c.coarse.value), range(c.coarse)); });
  return question + deviations + note + shares + maps_section(result, noise);
}

}  // namespace capcon
