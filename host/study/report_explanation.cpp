#include <fmt/format.h>

#include "study/html.h"
#include "study/report.h"

namespace capcon {
namespace {

std::string cost_cell(double value, double scale, const char* unit) {
  return fmt::format("{:.1f} {}", value * scale, unit);
}

}  // namespace

std::string report_explanation(const StudySettings& settings, const Explanation& e) {
  HtmlTable features("What this job uses of the scene and the program, and what was left out",
                     {"feature", "in the scene", "used or left out"});
  for (const FeatureRow& row : e.rows) {
    features.row(
        {escape(row.name), escape(row.in_scene), row.used ? "used" : "left out: " + escape(row.left_out)});
  }
  const std::uint32_t count = settings.samples[settings.samples.size() / 2];
  HtmlTable costs(fmt::format("The cost of one render at {} {}", count_label(settings, count),
                              words_of(settings.integral).many),
                  {"", "as needed", "everything kept", "saved"});
  const auto row = [&](const char* name, double needed, double everything, double scale, const char* unit) {
    costs.row({name, cost_cell(needed, scale, unit), cost_cell(everything, scale, unit),
               cost_cell(everything - needed, scale, unit)});
  };
  const Cost &a = e.needed, &b = e.everything;
  row("scene in memory", static_cast<double>(a.scene_bytes), static_cast<double>(b.scene_bytes), 1e-6, "MB");
  row("buffers on the device", static_cast<double>(a.device_bytes), static_cast<double>(b.device_bytes), 1e-6,
      "MB");
  row("reading", a.read_seconds, b.read_seconds, 1e3, "ms");
  row("building", a.build_seconds, b.build_seconds, 1e3, "ms");
  row("uploading", a.upload_seconds, b.upload_seconds, 1e3, "ms");
  row("compiling, the driver's cache empty", a.compile_seconds, b.compile_seconds, 1e3, "ms");
  row("device time, median", a.device_seconds, b.device_seconds, 1e3, "ms");
  return features.str() + costs.str() +
         fmt::format(
             "<p class=\"small\">Device time as needed over device time with everything kept: {:.3f} ({:.3f} "
             "to "
             "{:.3f} in {} interleaved repeats). The two images {}.</p>",
             e.device_ratio, e.device_ratio_low, e.device_ratio_high, e.repeats,
             e.identical ? "are the same, bit by bit" : "<strong>differ: this is a defect</strong>");
}

}  // namespace capcon
