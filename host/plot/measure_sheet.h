#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plot/canvas.h"
#include "points/measure.h"
#include "points/spectrum.h"

namespace capcon::plot {

/// What one column of the sheet shows.
struct SheetEntry {
  std::string title;
  std::size_t sets = 1;
  Points points;                     ///< the set that is drawn
  Measures measures;                 ///< means over the sets
  std::optional<Spectrum> spectrum;  ///< mean of the sets' periodograms; none where that was too dear
  RadialSpectrum radial;
};

/// Entries side by side, at most `columns` in a row (0: as many as make even rows, six at most). A column
/// holds the points in their Voronoi cells coloured by n area (up to kCropAbove points; of more a square
/// part), the mean power spectrum, its radial mean, its anisotropy, and the figures. Scales are common to all
/// columns.
class MeasureSheet {
 public:
  explicit MeasureSheet(std::vector<SheetEntry> entries, std::size_t columns = 0);

  double width() const;
  double height() const;
  void draw(Canvas& canvas) const;

 private:
  std::vector<SheetEntry> entries_;
  std::size_t columns_;
};

inline constexpr std::size_t kCropAbove = 4096;

}  // namespace capcon::plot
