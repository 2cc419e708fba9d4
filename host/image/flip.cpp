#include "image/flip.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "image/flip_colour.h"
#include "image/flip_filters.h"

namespace capcon {
namespace {

using namespace flip_colour;

/// A band of a plane of the image; rows and columns beyond the image repeat its border.
struct Plane {
  int width = 0, rows = 0;
  std::vector<double> values;
  Plane(int w, int r) : width(w), rows(r), values(std::size_t(w) * r) {}
  double* row(int y) { return values.data() + std::size_t(y) * width; }
  const double* row(int y) const { return values.data() + std::size_t(y) * width; }
};

/// `across` within each row, then `down`: `down`'s radius fewer rows at both ends. Adds to `out`.
void convolve(const Plane& in, const std::vector<double>& across, const std::vector<double>& down,
              Plane& out) {
  const int rx = static_cast<int>(across.size()) / 2, ry = static_cast<int>(down.size()) / 2;
  const int skip = (in.rows - 2 * ry - out.rows) / 2;
  Plane blurred(in.width, out.rows + 2 * ry);
  std::vector<double> padded(in.width + 2 * rx);
  for (int y = 0; y < blurred.rows; ++y) {
    const double* from = in.row(y + skip);
    for (int x = 0; x < in.width + 2 * rx; ++x) padded[x] = from[std::clamp(x - rx, 0, in.width - 1)];
    double* to = blurred.row(y);
    for (std::size_t k = 0; k < across.size(); ++k) {
      for (int x = 0; x < in.width; ++x) to[x] += across[k] * padded[x + k];
    }
  }
  for (int y = 0; y < out.rows; ++y) {
    double* to = out.row(y);
    for (std::size_t k = 0; k < down.size(); ++k) {
      const double* from = blurred.row(y + static_cast<int>(k));
      for (int x = 0; x < in.width; ++x) to[x] += down[k] * from[x];
    }
  }
}

/// What is computed of one image for some of its rows.
struct Side {
  std::vector<Vector> colours;  ///< Hunt-adjusted, blurred as the eye does
  std::vector<double> edges, points;
};

std::vector<double> lengths(const Plane& a, const Plane& b) {
  std::vector<double> result(a.values.size());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = std::hypot(a.values[i], b.values[i]);
  return result;
}

template <class ReadPixel>
Side side_of(const ReadPixel& read, bool grey, int width, int height, int first, int rows,
             const FlipFilters& f) {
  const int margin = std::max(f.blur_radius, f.feature_radius);
  std::array<Plane, 3> planes = {Plane(width, rows + 2 * margin), Plane(width, rows + 2 * margin),
                                 Plane(width, rows + 2 * margin)};
  Plane luminance(width, rows + 2 * margin);
  for (int y = 0; y < luminance.rows; ++y) {
    const int at = std::clamp(first + y - margin, 0, height - 1);
    for (int x = 0; x < width; ++x) {
      const Vector o = to_opponents(read(std::size_t(at) * width + x));
      for (int c = 0; c < 3; ++c) planes[c].row(y)[x] = o[c];
      luminance.row(y)[x] = (o[0] + 16) / 116;
    }
  }
  std::array<Plane, 3> seen = {Plane(width, rows), Plane(width, rows), Plane(width, rows)};
  const std::array<const FlipFilters::Sensitivity*, 3> filters = {&f.achromatic, &f.red_green,
                                                                  &f.blue_yellow};
  for (int c = 0; c < (grey ? 1 : 3); ++c) {  // a grey image has no chroma to blur
    for (const auto& part : filters[c]->parts) convolve(planes[c], part, part, seen[c]);
  }
  Side side;
  side.colours.resize(std::size_t(width) * rows);
  for (std::size_t i = 0; i < side.colours.size(); ++i) {
    Vector rgb = from_opponents({seen[0].values[i], seen[1].values[i], seen[2].values[i]});
    for (double& v : rgb) v = std::clamp(v, 0.0, 1.0);
    side.colours[i] = to_hunt_lab(rgb);
  }
  const auto feature = [&](const std::vector<double>& detector) {
    Plane across(width, rows), down(width, rows);
    convolve(luminance, detector, f.smooth, across);
    convolve(luminance, f.smooth, detector, down);
    return lengths(across, down);
  };
  side.edges = feature(f.edge);
  side.points = feature(f.point);
  return side;
}

/// LDR-FLIP of two readers of pixels.
template <class ReadPixel>
Image map_of(const ReadPixel& a, const ReadPixel& b, bool grey, int width, int height,
             double pixels_per_degree) {
  const FlipFilters filters(pixels_per_degree);
  Image map(width, height, 1);
  constexpr int kBand = 48;  // rows: few enough for large images' memory, many beside a filter's radius
  parallel_for((height + kBand - 1) / kBand, [&](std::size_t band) {
    const int first = static_cast<int>(band) * kBand;
    const int rows = std::min(kBand, height - first);
    const Side left = side_of(a, grey, width, height, first, rows, filters);
    const Side right = side_of(b, grey, width, height, first, rows, filters);
    for (std::size_t i = 0; i < left.edges.size(); ++i) {
      const double colour = redistributed(colour_distance(left.colours[i], right.colours[i]));
      const double feature =
          std::max(std::abs(left.edges[i] - right.edges[i]), std::abs(left.points[i] - right.points[i]));
      map.pixels[std::size_t(first) * width + i] =
          static_cast<float>(std::pow(colour, 1 - std::sqrt(feature / std::numbers::sqrt2)));
    }
  });
  return map;
}

void check_sizes(const Image& a, const Image& b) {
  if (a.width == b.width && a.height == b.height) return;
  throw InputError(
      fmt::format("the images differ in size: {} x {} against {} x {}; compare renders of one resolution",
                  a.width, a.height, b.width, b.height));
}

Vector pixel(const Image& image, std::size_t i) {
  const float* p = &image.pixels[i * image.channels];
  return image.channels == 1 ? Vector{p[0], p[0], p[0]} : Vector{p[0], p[1], p[2]};
}

bool finite(const Vector& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

double mean_of(const Image& map) {
  double sum = 0;
  for (const float v : map.pixels) sum += v;
  return sum / static_cast<double>(map.pixels.size());
}

/// A reader of `image`'s pixels through `curve`, black where one of the two is not finite.
template <class Curve>
auto reader(const Image& image, const Image& other, const Curve& curve) {
  return [&image, &other, curve](std::size_t i) {
    Vector v = pixel(image, i);
    if (!finite(v) || !finite(pixel(other, i))) return Vector{};
    for (double& c : v) c = std::clamp(curve(c), 0.0, 1.0);
    return v;
  };
}

// y = (a x^2 + b x) / (c x^2 + d x + e), with Narkowicz's numbers for x times 0.6.
constexpr double kA = 0.6 * 0.6 * 2.51, kB = 0.6 * 0.03, kC = 0.6 * 0.6 * 2.43, kD = 0.6 * 0.59, kE = 0.14;

double aces(double x) {
  return (kA * x * x + kB * x) / (kC * x * x + kD * x + kE);
}

/// What the curve maps to 0.85: the larger root of a quadratic.
double shown_brightest() {
  constexpr double kShown = 0.85;
  const double a = kA - kShown * kC, b = kB - kShown * kD, c = -kShown * kE;
  return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

}  // namespace

Image flip_map(const Image& image, const Image& reference, double pixels_per_degree) {
  check_sizes(image, reference);
  const auto same = [](double v) { return v; };
  return map_of(reader(image, reference, same), reader(reference, image, same),
                image.channels == 1 && reference.channels == 1, image.width, image.height, pixels_per_degree);
}

double flip(const Image& image, const Image& reference, double pixels_per_degree) {
  return mean_of(flip_map(image, reference, pixels_per_degree));
}

HdrFlip hdr_flip(const Image& image, const Image& reference, double pixels_per_degree) {
  check_sizes(image, reference);
  const std::size_t count = std::size_t(reference.width) * reference.height;
  std::vector<double> luminances;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector v = pixel(reference, i);
    if (finite(v)) luminances.push_back(std::max(0.0, luminance(v)));
  }
  HdrFlip result;
  std::vector<double> exposures = {0};
  const double brightest = luminances.empty() ? 0 : *std::max_element(luminances.begin(), luminances.end());
  if (brightest > 0) {
    const auto middle = luminances.begin() + static_cast<std::ptrdiff_t>((luminances.size() - 1) / 2);
    std::nth_element(luminances.begin(), middle, luminances.end());
    constexpr double kDarkest = 1e-6;  // of the brightest: a reference that is mostly black has a median too
    result.start = std::log2(shown_brightest() / brightest);
    result.stop = std::log2(shown_brightest() / std::max(*middle, kDarkest * brightest));
    const int steps = std::max(2, static_cast<int>(std::ceil(result.stop - result.start)));
    exposures.clear();
    for (int i = 0; i < steps; ++i)
      exposures.push_back(result.start + (result.stop - result.start) * i / (steps - 1));
  }
  result.exposures = static_cast<unsigned>(exposures.size());
  Image largest(reference.width, reference.height, 1);
  for (const double exposure : exposures) {
    const double factor = std::exp2(exposure);
    const auto curve = [factor](double v) { return aces(std::max(0.0, factor * v)); };
    const Image map =
        map_of(reader(image, reference, curve), reader(reference, image, curve),
               image.channels == 1 && reference.channels == 1, image.width, image.height, pixels_per_degree);
    for (std::size_t i = 0; i < count; ++i) largest.pixels[i] = std::max(largest.pixels[i], map.pixels[i]);
  }
  result.value = mean_of(largest);
  return result;
}

}  // namespace capcon
