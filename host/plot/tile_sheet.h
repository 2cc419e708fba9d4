#pragma once

#include <string>
#include <vector>

#include "plot/canvas.h"
#include "tiling/tile_report.h"

namespace capcon::plot {

/// What is known of a tile set, ready to be drawn.
struct TileSheetData {
  std::string name;
  TileSet set;
  TileReport report;
  std::vector<TilingFigures> sizes;  ///< of the tilings that are drawn: 4 x 4, 8 x 8, 16 x 16 tiles
  std::uint32_t tilings = 20;        ///< in every mean, and periodograms in the spectrum
};

/// Measures a set for its sheet.
TileSheetData tile_sheet_data(const std::string& name, const TileSet& set, const TileReportOptions& options);

/// One page on the quality of a tile set: three tilings with their figures beside those of points made
/// without tiles, the mean spectrum of 8 x 8 tilings with the multiples of the tile frequency marked, its
/// radial mean, and the mean distance of every prefix of the ranks.
class TileSheet {
 public:
  explicit TileSheet(TileSheetData data) : data_(std::move(data)) {}

  static constexpr double kWidth = 1010, kHeight = 810;
  void draw(Canvas& canvas) const;

 private:
  void draw_tilings(Canvas& canvas, double top) const;
  void draw_spectrum_panel(Canvas& canvas, const Box& box) const;
  void draw_radial(Canvas& canvas, const Box& box) const;
  void draw_prefixes(Canvas& canvas, const Box& box) const;

  TileSheetData data_;
};

}  // namespace capcon::plot
