#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace capcon {

/// A site of the torus in one of its 25 images nearest to the unit square, in one word.
class SiteImage {
 public:
  SiteImage() = default;
  /// The site moved by (x, y) periods, each from -2 to 2.
  SiteImage(std::uint32_t site, int x, int y)
      : code_(site * 25 + static_cast<std::uint32_t>(5 * y + x + 12)) {}
  std::uint32_t site() const { return code_ / 25; }
  int x() const { return static_cast<int>(code_ % 25 % 5) - 2; }
  int y() const { return static_cast<int>(code_ % 25 / 5) - 2; }
  bool operator==(const SiteImage&) const = default;

 private:
  std::uint32_t code_ = 0;
};

/// What a convex polygon weighs, about the origin.
struct Moments {
  double area = 0;
  glm::dvec2 first{0};  ///< integral of x
  double second = 0;    ///< integral of |x|^2
};

/// A convex polygon, counter-clockwise, relative to a site, that remembers which image of a site lies beyond
/// each of its edges.
class PowerCell {
 public:
  /// The points nearer to the site than to its own images: the unit square about it.
  void reset(std::uint32_t site);
  /// Keeps the points p with p . d <= limit; `beyond` lies behind the new edge. Returns whether that cut
  /// anything off.
  bool cut(glm::dvec2 d, double limit, SiteImage beyond);

  std::size_t size() const { return x_.size(); }
  bool empty() const { return x_.empty(); }
  glm::dvec2 corner(std::size_t k) const { return {x_[k], y_[k]}; }
  /// Behind the edge from corner k to the next.
  SiteImage beyond(std::size_t k) const { return beyond_[k]; }
  Moments moments() const;

 private:
  std::vector<double> x_, y_, side_;
  std::vector<SiteImage> beyond_;
  std::vector<double> next_x_, next_y_;
  std::vector<SiteImage> next_beyond_;
};

}  // namespace capcon
