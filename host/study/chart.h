#pragma once

#include <string>
#include <vector>

#include "base/statistics.h"
#include "study/log_axis.h"

namespace capcon {

struct ChartPoint {
  Interval x;  ///< ends NaN where it is exact
  Interval y;
  bool sure = true;  ///< drawn filled; else hollow
  std::string note;  ///< shown by browsers under the pointer
};

struct ChartLine {
  std::string name;
  int style = 0;        ///< marker and colour: class "s<style>" of the page's style sheet
  bool strong = false;  ///< the line a study is about
  std::vector<ChartPoint> points;
  std::vector<ChartPoint> companion;  ///< dashed, without markers; may be empty
  int dash = 0;                       ///< class "d<dash>": which of several results; 0: one of one
};

struct Chart {
  std::string id;     ///< unique in the page
  std::string title;  ///< for those who cannot see it
  std::string description;
  std::string x_label;
  std::string y_label;
  LogAxis::Style x_style = LogAxis::Style::decades;
  LogAxis::Style y_style = LogAxis::Style::decades;
  bool line_at_one = false;  ///< a heavier line at y = 1
  std::vector<ChartLine> lines;
  double name_room = 116;  ///< for the longest name at the right, of 560 in all
};

/// A log-log chart as inline SVG: grid with minor ticks, 95 % bars, a marker and colour a line, and the
/// line's name at its end. Colours come from the page's style sheet.
std::string svg_chart(const Chart& chart);

/// The chart as a figure of a page: the drawing, and its data for the charts that scripts put in its place.
/// `caption` is HTML.
std::string chart_figure(const Chart& chart, const std::string& caption);

/// A small picture of a line's marker, for tables and legends.
std::string svg_marker(int style);

}  // namespace capcon
