#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <utility>
#include <vector>

namespace capcon {

/// A density on the unit square, constant in each texel of a grid; only ratios matter. Texel (column, row)
/// covers [column, column + 1] / width x [row, row + 1] / height: row 0 of an image, its top, is at y = 0.
class Density {
 public:
  static constexpr std::size_t kMostTexels = 1 << 26;

  /// Row by row. InputError, naming the texel, for a value that is negative or not finite; when all are 0;
  /// for more than 2^26 texels.
  Density(std::size_t width, std::size_t height, std::vector<double> values);
  /// The function at the midpoints of a grid. InputError naming the place (x, y) likewise.
  static Density of(const std::function<double(double x, double y)>& function, std::size_t side = 1024);

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }
  /// Relative to the largest.
  double at(std::size_t column, std::size_t row) const { return values_[row * width_ + column]; }

  /// The corners of the least rectangle of texels that holds all mass.
  std::pair<glm::dvec2, glm::dvec2> support() const;

  /// Sends the unit square to itself so that equal areas become equal masses: y by the inverse of the
  /// marginal distribution, then x by that of its row. u in [0, 1)^2; so is the result, never in a texel of
  /// density 0.
  glm::dvec2 warp(glm::dvec2 u) const;

  /// The same density with the texels cleared that lie outside the disk of radius 1/2 about (1/2, 1/2)
  /// altogether. InputError when nothing is left.
  Density about_disk() const;

 private:
  void accumulate();

  std::size_t width_, height_;
  std::vector<double> values_;   ///< the largest is 1
  std::vector<double> rows_;     ///< mass of the rows before, height + 1
  std::vector<double> columns_;  ///< of the texels before in the row, (width + 1) a row
};

}  // namespace capcon
