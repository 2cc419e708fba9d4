#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "image/image.h"
#include "plot/canvas.h"
#include "render/view.h"
#include "shading/virtual_light.h"

namespace capcon {

/// Whether the segments from the eye to the points are free, one flag a point.
using SeenFromEye =
    std::function<std::vector<bool>(const glm::dvec3& eye, std::span<const glm::dvec3> points)>;

/// Where a point of the world lies on the film, in pixels from its upper left corner; nothing behind the eye.
std::optional<glm::dvec2> on_film(const View& view, const glm::dvec3& point);

/// A VPL that the camera sees.
struct LightDot {
  glm::dvec2 place;          ///< on the film, pixels
  std::uint32_t set = 0;     ///< of its set
  std::uint32_t bounce = 1;  ///< 1: where its path first hit
  double strength = 1;       ///< luminance of its flux over the mean of all VPLs that carry any
};

/// The VPLs within a film of width x height pixels whose surface is turned to the eye and that nothing hides,
/// by falling strength: the weak ones are drawn over the strong.
std::vector<LightDot> light_dots(const VirtualLights& lights, const View& view, int width, int height,
                                 const SeenFromEye& seen);

/// Radius of a dot in pixels of a film of this width: its area goes with its strength, within bounds that
/// keep every dot visible.
double dot_radius(const LightDot& dot, int width);

/// A picture of the VPLs: dots over `background` (the scene's image, dimmed and grey), a colour a set, or a
/// colour a bounce where there is one set only, and below it what the colours mean.
class LightPicture {
 public:
  LightPicture(const Image& background, const VirtualLights& lights, std::vector<LightDot> dots);

  double width() const { return width_; }
  double height() const { return height_; }
  void draw(plot::Canvas& canvas) const;
  /// Colour of a dot, as the legend has it.
  plot::Colour colour(const LightDot& dot) const;

 private:
  void draw_legend(plot::Canvas& canvas) const;

  plot::Pixels ground_;
  double width_ = 0, height_ = 0;
  std::uint32_t sets_ = 1;
  std::size_t all_ = 0;
  std::vector<LightDot> dots_;
};

}  // namespace capcon
