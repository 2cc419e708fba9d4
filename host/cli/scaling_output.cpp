#include "cli/scaling_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "plot/curve_chart.h"
#include "plot/palette.h"
#include "plot/picture_file.h"

namespace capcon::cli {
namespace {

using Cost = std::function<double(const ScalingPoint&)>;

struct Column {
  const char* name;
  Cost capcon, embree;
};

std::vector<Column> columns() {
  return {{"primary", [](const auto& p) { return p.capcon.primary; },
           [](const auto& p) { return p.embree.primary; }},
          {"occlusion", [](const auto& p) { return p.capcon.occlusion; },
           [](const auto& p) { return p.embree.occlusion; }}};
}

bool has_embree(const std::vector<ScalingPoint>& points) {
  return !points.empty() && points[0].embree.primary > 0;
}

const char* title(const ScalingSeries& series) {
  return series.name == "finer" ? "One surface, all triangles its own"
                                : "The same square, instances of one surface";
}

nlohmann::json series_json(const std::vector<ScalingPoint>& points) {
  nlohmann::json rows = nlohmann::json::array(), growth;
  for (const ScalingPoint& p : points) {
    nlohmann::json row = {{"triangles", p.triangles},
                          {"build_seconds", p.build_seconds},
                          {"bytes_per_triangle", p.bytes_per_triangle}};
    for (const Column& c : columns()) {
      row["capcon_nanoseconds"][c.name] = c.capcon(p);
      if (has_embree(points)) row["embree_nanoseconds"][c.name] = c.embree(p);
    }
    rows.push_back(row);
  }
  for (const Column& c : columns()) {
    growth["capcon"][c.name] = growth_per_tenfold(points, c.capcon);
    if (has_embree(points)) growth["embree"][c.name] = growth_per_tenfold(points, c.embree);
  }
  return {{"points", rows}, {"growth_per_tenfold", growth}};
}

void print_series(const std::vector<ScalingPoint>& points) {
  const bool embree = has_embree(points);
  fmt::print("{:>10} {:>8} {:>9}  {:>22}  {:>22}\n", "", "build", "bytes per", "ns a primary ray",
             "ns an occlusion ray");
  fmt::print("{:>10} {:>8} {:>9}", "triangles", "seconds", "triangle");
  for (int k = 0; k < 2; ++k) fmt::print("  {:>11}{:>11}", "capcon", embree ? "Embree" : "");
  fmt::print("\n");
  const auto cell = [&](double v) { return embree ? fmt::format("{:.0f}", v) : std::string(); };
  for (const ScalingPoint& p : points) {
    fmt::print("{:>10} {:>8.2f} {:>9.0f}", p.triangles, p.build_seconds, p.bytes_per_triangle);
    for (const Column& c : columns()) fmt::print("  {:>11.0f}{:>11}", c.capcon(p), cell(c.embree(p)));
    fmt::print("\n");
  }
  fmt::print("{:<29}", "growth per tenfold");
  for (const Column& c : columns()) {
    fmt::print("  {:>11.2f}{:>11}", growth_per_tenfold(points, c.capcon),
               embree ? fmt::format("{:.2f}", growth_per_tenfold(points, c.embree)) : "");
  }
  fmt::print("\n");
}

constexpr double kWidth = 300, kHeight = 190, kLeft = 60, kTop = 64, kGap = 70, kBelow = 40;

/// Panels side by side, one for each kind of rays, from `top` down.
void draw_series(plot::Canvas& canvas, const ScalingSeries& series, double top) {
  const std::vector<ScalingPoint>& points = series.points;
  canvas.text({kLeft, top - 44}, title(series), {.colour = plot::kInk, .size = 13});
  double x = kLeft;
  for (const Column& c : columns()) {
    std::vector<glm::dvec2> ours, theirs;
    plot::Axis across{.low = 4, .high = 4.5, .ticks = {}, .label = "triangles, power of ten"};
    double highest = 1;
    for (const ScalingPoint& p : points) {
      const double place = std::log10(static_cast<double>(p.triangles));
      ours.emplace_back(place, c.capcon(p));
      theirs.emplace_back(place, has_embree(points) ? c.embree(p) : std::nan(""));
      across.low = std::min(across.low, std::floor(place * 100) / 100);
      across.high = std::max({across.high, place, std::round(place)});
      across.ticks.push_back(std::round(place));
      highest = std::max({highest, c.capcon(p), c.embree(p)});
    }
    const double step = std::pow(10, std::floor(std::log10(highest))) /
                        (highest < 3 * std::pow(10, std::floor(std::log10(highest))) ? 2 : 1);
    plot::Axis up{.low = 0,
                  .high = step * std::ceil(highest / step),
                  .ticks = {},
                  .label = fmt::format("ns a ray, {}", c.name)};
    for (double tick = 0; tick <= up.high + 0.5 * step; tick += step) up.ticks.push_back(tick);
    const plot::Box box{x, top, kWidth, kHeight};
    plot::draw_curve(canvas, box, across, up, {}, theirs, plot::kRed);
    plot::draw_curve(canvas, box, across, up, {}, ours, plot::kBlue);
    const auto name = [&](double above, const char* tracer, const auto& column, const auto& colour) {
      canvas.text({x, top - above},
                  fmt::format("{}: x{:.2f} per tenfold", tracer, growth_per_tenfold(points, column)),
                  {.colour = colour, .size = 11});
    };
    name(25, "capcon", c.capcon, plot::kBlue);
    if (has_embree(points)) name(10, "Embree, single rays", c.embree, plot::kRed);
    x += kWidth + kGap;
  }
}

}  // namespace

nlohmann::json scaling_json(const std::vector<ScalingSeries>& series) {
  nlohmann::json all;
  for (const ScalingSeries& one : series) all[one.name] = series_json(one.points);
  return all;
}

void print_scaling(const std::vector<ScalingSeries>& series) {
  for (const ScalingSeries& one : series) {
    fmt::print("{}{}\n", &one == series.data() ? "" : "\n", title(one));
    print_series(one.points);
  }
}

void draw_scaling(const std::vector<ScalingSeries>& series, const std::string& path) {
  const double each = kTop + kHeight + kBelow;
  plot::write_picture(path, kLeft + 2 * kWidth + kGap + 20, each * static_cast<double>(series.size()) + 5,
                      [&](plot::Canvas& canvas) {
                        for (std::size_t k = 0; k < series.size(); ++k)
                          draw_series(canvas, series[k], kTop + each * static_cast<double>(k));
                      });
}

}  // namespace capcon::cli
