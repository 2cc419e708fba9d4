#include "plot/palette.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace capcon::plot {

Colour diverging(double t) {
  // Lightness falls evenly to both sides; blue and orange differ for every kind of colour vision.
  static constexpr Colour kStops[] = {{23, 74, 128},   {72, 139, 190}, {158, 201, 225}, {246, 245, 240},
                                      {250, 196, 128}, {222, 128, 40}, {150, 70, 10}};
  const double place = (std::clamp(t, -1.0, 1.0) + 1) / 2 * (std::size(kStops) - 1);
  const auto below = std::min<std::size_t>(std::size_t(place), std::size(kStops) - 2);
  const auto mix = [&](std::uint8_t a, std::uint8_t b) {
    return std::uint8_t(std::lround(a + (place - double(below)) * (double(b) - a)));
  };
  const Colour a = kStops[below], b = kStops[below + 1];
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

Colour grey(double t) {
  const auto v = std::uint8_t(std::lround(255 * std::clamp(t, 0.0, 1.0)));
  return {v, v, v};
}

}  // namespace capcon::plot
