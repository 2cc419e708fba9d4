#include "study/virtual_light_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "plot/palette.h"
#include "shading/spectrum.h"

namespace capcon {
namespace {

constexpr std::uint32_t kBounces = 6;     // the last colour stands for this bounce and all later ones
constexpr std::uint32_t kNamedSets = 16;  // more are a strip from the first to the last
constexpr double kRow = 20;               // of the legend
constexpr plot::Colour kOutline{12, 13, 15};

std::uint8_t byte_of(double linear) {
  const double v = std::clamp(linear, 0.0, 1.0);
  return static_cast<std::uint8_t>(
      std::lround(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055)));
}

/// Grey and dim, so that dots stand out and the room is still known.
plot::Pixels dimmed(const Image& image) {
  constexpr double kDim = 0.34;
  plot::Pixels pixels{image.width, image.height, {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const double grey = image.channels == 3
                              ? luminance({image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)})
                              : image.at(x, y, 0);
      const std::uint8_t v = byte_of(kDim * grey / (1 + 0.5 * grey) + 0.004);
      pixels.colours.push_back({v, v, v});
    }
  }
  return pixels;
}

/// Light colours all around the circle of hues, in OKLCh (Ottosson, "A perceptual color space for image
/// processing", 2020).
plot::Colour hue_colour(double turn) {
  constexpr double kLightness = 0.78, kChroma = 0.13;
  const double a = kChroma * std::cos(2 * std::numbers::pi * turn);
  const double b = kChroma * std::sin(2 * std::numbers::pi * turn);
  const double l = std::pow(kLightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(kLightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(kLightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  return {byte_of(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          byte_of(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          byte_of(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

/// From the first bounce on: pale yellow over orange and violet to blue.
plot::Colour bounce_colour(std::uint32_t bounce) {
  static constexpr std::array<plot::Colour, kBounces> kColours = {
      {{255, 241, 150}, {255, 176, 72}, {245, 96, 84}, {214, 92, 190}, {130, 110, 240}, {80, 170, 255}}};
  return kColours[std::min(bounce, kBounces) - 1];
}

}  // namespace

std::optional<glm::dvec2> on_film(const View& view, const glm::dvec3& point) {
  // point - eye = s (corner + x across + y down)
  const glm::dmat3 film(view.corner, view.across, view.down);
  const glm::dvec3 solved = glm::inverse(film) * (point - view.eye);
  if (!(solved.x > 0)) return std::nullopt;
  return glm::dvec2(solved.y, solved.z) / solved.x;
}

std::vector<LightDot> light_dots(const VirtualLights& lights, const View& view, int width, int height,
                                 const SeenFromEye& seen) {
  double sum = 0;
  std::size_t carrying = 0;
  std::vector<LightDot> dots;
  std::vector<glm::dvec3> points;
  for (std::uint32_t set = 0; set < lights.sets(); ++set) {
    for (std::uint32_t k = lights.first[set]; k < lights.first[set + 1]; ++k) {
      const VirtualLight& light = lights.lights[k];
      const double flux = luminance(light.flux);
      if (!(flux > 0)) continue;
      sum += flux;
      ++carrying;
      const auto place = on_film(view, light.position);
      if (!place || place->x < 0 || place->y < 0 || place->x >= width || place->y >= height) continue;
      if (glm::dot(light.normal, view.eye - light.position) <= 0) continue;  // lies on the other side
      dots.push_back({*place, set, light.bounce, flux});
      points.push_back(light.position);
    }
  }
  const std::vector<bool> free = points.empty() ? std::vector<bool>() : seen(view.eye, points);
  std::vector<LightDot> visible;
  for (std::size_t i = 0; i < dots.size(); ++i) {
    if (!free[i]) continue;
    visible.push_back(dots[i]);
    visible.back().strength = dots[i].strength / (sum / static_cast<double>(carrying));
  }
  std::stable_sort(visible.begin(), visible.end(),
                   [](const LightDot& a, const LightDot& b) { return a.strength > b.strength; });
  return visible;
}

double dot_radius(const LightDot& dot, int width) {
  const double usual = std::max(1.5, 0.0042 * width);
  return usual * std::sqrt(std::clamp(dot.strength, 0.25, 6.0));
}

LightPicture::LightPicture(const Image& background, const VirtualLights& lights, std::vector<LightDot> dots)
    : ground_(dimmed(background)),
      width_(background.width),
      sets_(lights.sets()),
      all_(lights.lights.size()),
      dots_(std::move(dots)) {
  const std::uint32_t names = sets_ == 1 ? kBounces : std::min(sets_, kNamedSets);
  const double columns = std::max(1.0, std::floor((width_ - 16) / 68));
  height_ = background.height + 8 + kRow * (1 + std::ceil(names / columns)) + 6;
}

plot::Colour LightPicture::colour(const LightDot& dot) const {
  return sets_ == 1 ? bounce_colour(dot.bounce) : hue_colour(0.08 + static_cast<double>(dot.set) / sets_);
}

void LightPicture::draw(plot::Canvas& canvas) const {
  const plot::Box film{0, 0, static_cast<double>(ground_.width), static_cast<double>(ground_.height)};
  canvas.image(film, ground_);
  canvas.begin_clip(film);
  for (const LightDot& dot : dots_) {
    const double radius = dot_radius(dot, ground_.width);
    canvas.disc(dot.place, radius + 0.8, kOutline);
    canvas.disc(dot.place, radius, colour(dot));
  }
  canvas.end_clip();
  draw_legend(canvas);
}

void LightPicture::draw_legend(plot::Canvas& canvas) const {
  const double top = ground_.height;
  canvas.rectangle({0, top, width_, height_ - top}, {24, 26, 30});
  const plot::TextStyle text{{225, 227, 224}, 11, plot::Anchor::kStart, false, false};
  double y = top + 8 + kRow * 0.7;
  canvas.text({10, y},
              fmt::format("{} of {} virtual lights in view; area: flux; colour: {}", dots_.size(), all_,
                          sets_ == 1 ? "bounce" : "set"),
              text);
  const std::uint32_t names = sets_ == 1 ? kBounces : std::min(sets_, kNamedSets);
  const auto columns = static_cast<std::uint32_t>(std::max(1.0, std::floor((width_ - 16) / 68)));
  for (std::uint32_t i = 0; i < names; ++i) {
    const glm::dvec2 at(16 + 68.0 * (i % columns), y + kRow * (1 + static_cast<double>(i / columns)));
    // Of more sets than have a name, evenly spaced ones.
    const std::uint32_t set = static_cast<std::uint32_t>(std::uint64_t(i) * sets_ / names);
    const LightDot example{{}, set, i + 1, 1};
    canvas.disc({at.x, at.y - 4}, 4.5, colour(example));
    const std::string name = sets_ > 1          ? fmt::format("set {}", set)
                             : i + 1 < kBounces ? fmt::format("{}", i + 1)
                                                : fmt::format("{} ...", i + 1);
    canvas.text({at.x + 9, at.y}, name, text);
  }
}

}  // namespace capcon
