#include "image/flip.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "base/error.h"

namespace capcon {
namespace {

// An evaluation of the papers' formulas written for this test alone: one pixel at a time, dense filters.
namespace slow {

using Colour = std::array<double, 3>;
constexpr double kPi = 3.14159265358979323846;

Colour xyz(const Colour& c) {
  return {0.412390799 * c[0] + 0.357584339 * c[1] + 0.180480788 * c[2],
          0.212639006 * c[0] + 0.715168679 * c[1] + 0.072192315 * c[2],
          0.019330819 * c[0] + 0.119194780 * c[1] + 0.950532152 * c[2]};
}

Colour rgb(const Colour& c) {
  return {3.240969942 * c[0] - 1.537383178 * c[1] - 0.498610760 * c[2],
          -0.969243636 * c[0] + 1.875967502 * c[1] + 0.041555057 * c[2],
          0.055630080 * c[0] - 0.203976959 * c[1] + 1.056971514 * c[2]};
}

const Colour kWhite = xyz({1, 1, 1});

Colour opponents(const Colour& c) {
  const Colour v = xyz(c);
  const double x = v[0] / kWhite[0], y = v[1] / kWhite[1], z = v[2] / kWhite[2];
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Colour lab(const Colour& c) {
  Colour v = xyz(c);
  for (int i = 0; i < 3; ++i) {
    const double t = v[i] / kWhite[i];
    v[i] = t > 216.0 / 24389 ? std::pow(t, 1.0 / 3) : t * 841 / 108 + 16.0 / 116;
  }
  const double l = 116 * v[1] - 16;
  return {l, 0.01 * l * 500 * (v[0] - v[1]), 0.01 * l * 200 * (v[1] - v[2])};
}

double distance(const Colour& a, const Colour& b) {
  return std::pow(std::fabs(a[0] - b[0]) + std::sqrt(std::pow(a[1] - b[1], 2) + std::pow(a[2] - b[2], 2)),
                  0.7);
}

double colour_error(const Colour& a, const Colour& b) {
  const double most = distance(lab({0, 1, 0}), lab({0, 0, 1}));
  const double d = distance(a, b);
  if (d < 0.4 * most) return 0.95 * d / (0.4 * most);
  return 0.95 + 0.05 * (d - 0.4 * most) / (0.6 * most);
}

struct Picture {
  int width, height;
  std::vector<Colour> colours;  // linear, in [0, 1]
  Colour at(int x, int y) const {
    return colours[std::size_t(std::min(std::max(y, 0), height - 1)) * width +
                   std::min(std::max(x, 0), width - 1)];
  }
};

Picture picture_of(const Image& image) {
  Picture p{image.width, image.height, {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      Colour c;
      for (int k = 0; k < 3; ++k)
        c[k] = std::min(1.f, std::max(0.f, image.at(x, y, image.channels == 1 ? 0 : k)));
      p.colours.push_back(c);
    }
  }
  return p;
}

double sensitivity(int channel, double square) {
  if (channel == 0) return std::sqrt(kPi / 0.0047) * std::exp(-kPi * kPi * square / 0.0047);
  if (channel == 1) return std::sqrt(kPi / 0.0053) * std::exp(-kPi * kPi * square / 0.0053);
  return 34.1 * std::sqrt(kPi / 0.04) * std::exp(-kPi * kPi * square / 0.04) +
         13.5 * std::sqrt(kPi / 0.025) * std::exp(-kPi * kPi * square / 0.025);
}

Colour seen(const Picture& p, int x, int y, double per_degree) {
  const int r = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * per_degree));
  Colour sum{}, weights{};
  for (int v = -r; v <= r; ++v) {
    for (int u = -r; u <= r; ++u) {
      const Colour o = opponents(p.at(x + u, y + v));
      for (int c = 0; c < 3; ++c) {
        const double w = sensitivity(c, (u * u + v * v) / (per_degree * per_degree));
        sum[c] += w * o[c];
        weights[c] += w;
      }
    }
  }
  for (int c = 0; c < 3; ++c) sum[c] /= weights[c];
  const double yy = (sum[0] + 16) / 116;
  Colour back = rgb({(yy + sum[1] / 500) * kWhite[0], yy * kWhite[1], (yy - sum[2] / 200) * kWhite[2]});
  for (double& c : back) c = std::min(1.0, std::max(0.0, c));
  return lab(back);
}

/// The length of (d/dx, d/dy), first or second derivatives.
double feature(const Picture& p, int x, int y, double per_degree, bool points) {
  const double sd = 0.5 * 0.082 * per_degree;
  const int r = static_cast<int>(std::ceil(3 * sd));
  const auto kernel = [&](int u, int v) {
    const double g = std::exp(-(u * u + v * v) / (2 * sd * sd));
    return points ? (u * u / (sd * sd) - 1) * g : -u * g;
  };
  double up = 0, down = 0;
  for (int v = -r; v <= r; ++v) {
    for (int u = -r; u <= r; ++u) (kernel(u, v) > 0 ? up : down) += std::fabs(kernel(u, v));
  }
  double gx = 0, gy = 0;
  for (int v = -r; v <= r; ++v) {
    for (int u = -r; u <= r; ++u) {
      const double w = kernel(u, v) / (kernel(u, v) > 0 ? up : down);
      gx += w * (opponents(p.at(x + u, y + v))[0] + 16) / 116;
      gy += w * (opponents(p.at(x + v, y + u))[0] + 16) / 116;
    }
  }
  return std::sqrt(gx * gx + gy * gy);
}

double flip_at(const Picture& a, const Picture& b, int x, int y, double per_degree) {
  const double colour = colour_error(seen(a, x, y, per_degree), seen(b, x, y, per_degree));
  const double edges = std::fabs(feature(a, x, y, per_degree, false) - feature(b, x, y, per_degree, false));
  const double points = std::fabs(feature(a, x, y, per_degree, true) - feature(b, x, y, per_degree, true));
  return std::pow(colour, 1 - std::sqrt(std::max(edges, points) / std::sqrt(2.0)));
}

}  // namespace slow

Image noise(int width, int height, int channels, unsigned seed, float scale = 1) {
  Image image(width, height, channels);
  std::mt19937 random(seed);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] =
        scale * (static_cast<float>(random() % 1000) / 800 + 0.2f * static_cast<float>(i % 7 == 0));
  return image;
}

Image constant(float r, float g, float b, int size = 4) {
  Image image(size, size, 3);
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    image.pixels[i] = r;
    image.pixels[i + 1] = g;
    image.pixels[i + 2] = b;
  }
  return image;
}

TEST(Flip, OfConstantImagesIsTheColoursDistance) {
  // HyAB(black, white) = 100, HyAB(green, blue) = 203.3 with Hunt's chroma: by hand 0.967.
  EXPECT_NEAR(flip(constant(0, 0, 0), constant(1, 1, 1)), 0.9674, 2e-4);
  EXPECT_NEAR(flip(constant(0, 1, 0), constant(0, 0, 1)), 1, 1e-6);
  for (const auto& [a, b] : {std::pair{slow::Colour{0.2, 0.3, 0.4}, slow::Colour{0.25, 0.3, 0.35}},
                             {slow::Colour{0.9, 0.1, 0.5}, slow::Colour{0.1, 0.9, 0.2}}}) {
    const auto image = [](const slow::Colour& c) {
      return constant(static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]));
    };
    EXPECT_NEAR(flip(image(a), image(b)), slow::colour_error(slow::lab(a), slow::lab(b)), 1e-5);
  }
}

TEST(Flip, OfAnImageWithItselfIsNothingAndOrderIsNothing) {
  const Image a = noise(60, 55, 3, 1), b = noise(60, 55, 3, 2);
  EXPECT_EQ(flip(a, a), 0);
  EXPECT_EQ(flip(a, b), flip(b, a));
  EXPECT_GT(flip(a, b), 0.1);
  EXPECT_LT(flip(a, b), 1);
}

TEST(Flip, AgreesWithADenseEvaluation) {
  // Its matrix is the one of ten rounded digits, FLIP's the exact one of slightly another white: 1e-5.
  // Larger than a band of rows, and with colours beyond 1, which are clamped.
  for (const int channels : {1, 3}) {
    for (const double per_degree : {20.0, 30.0}) {
      const Image a = noise(23, 61, channels, 3), b = noise(23, 61, channels, 4);
      const Image map = flip_map(a, b, per_degree);
      const slow::Picture pa = slow::picture_of(a), pb = slow::picture_of(b);
      for (const auto& [x, y] : {std::pair{0, 0}, {22, 60}, {11, 47}, {12, 48}, {5, 30}, {22, 49}, {0, 33}})
        EXPECT_NEAR(map.at(x, y, 0), slow::flip_at(pa, pb, x, y, per_degree), 3e-5) << x << " " << y;
    }
  }
  const Image a = noise(31, 17, 3, 5), b = noise(31, 17, 3, 6);
  const double usual = 0.7 * 3840 / 0.7 * slow::kPi / 180;
  EXPECT_NEAR(flip_map(a, b).at(15, 8, 0),
              slow::flip_at(slow::picture_of(a), slow::picture_of(b), 15, 8, usual), 3e-5);
}

TEST(Flip, ABlackOrWhitePixelInTheOtherImageCounts) {
  Image a = constant(0.5f, 0.5f, 0.5f, 40);
  Image b = a;
  for (int c = 0; c < 3; ++c) b.at(20, 20, c) = 1;
  const Image map = flip_map(a, b);
  EXPECT_GT(map.at(20, 20, 0), 0.05);
  EXPECT_EQ(map.at(0, 0, 0), 0);  // farther than the filters reach
}

TEST(Flip, WhatIsNotFiniteIsBlackInBoth) {
  Image a = constant(0.5f, 0.5f, 0.5f), b = a;
  a.pixels[0] = std::numeric_limits<float>::quiet_NaN();
  b.pixels[9] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(flip(a, b), 0);
  EXPECT_EQ(hdr_flip(a, b).value, 0);
  EXPECT_THROW(flip(a, Image(2, 2, 3)), InputError);
  EXPECT_THROW(hdr_flip(a, Image(2, 2, 3)), InputError);
}

double aces(double x) {
  x *= 0.6;
  return std::min(1.0, (x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14));
}

TEST(HdrFlip, IsTheLargestOverItsExposures) {
  const Image a = noise(20, 12, 3, 7, 30), b = noise(20, 12, 3, 8, 30);
  const HdrFlip hdr = hdr_flip(a, b);
  // The brightest and the median luminance of the reference end at 0.85.
  std::vector<double> luminances;
  for (std::size_t i = 0; i < b.pixels.size(); i += 3)
    luminances.push_back(0.212639006 * b.pixels[i] + 0.715168679 * b.pixels[i + 1] +
                         0.072192315 * b.pixels[i + 2]);
  std::sort(luminances.begin(), luminances.end());
  EXPECT_NEAR(aces(luminances.back() * std::exp2(hdr.start)), 0.85, 1e-5);
  EXPECT_NEAR(aces(luminances[luminances.size() / 2 - 1] * std::exp2(hdr.stop)), 0.85, 1e-5);
  EXPECT_GE(hdr.exposures, 2u);
  Image largest(20, 12, 1);
  for (unsigned i = 0; i < hdr.exposures; ++i) {
    const double factor = std::exp2(hdr.start + (hdr.stop - hdr.start) * i / (hdr.exposures - 1));
    Image ta = a, tb = b;
    for (float& v : ta.pixels) v = static_cast<float>(aces(v * factor));
    for (float& v : tb.pixels) v = static_cast<float>(aces(v * factor));
    const Image map = flip_map(ta, tb);
    for (std::size_t p = 0; p < map.pixels.size(); ++p)
      largest.pixels[p] = std::max(largest.pixels[p], map.pixels[p]);
  }
  double mean = 0;
  for (const float v : largest.pixels) mean += v / 240.0;
  EXPECT_NEAR(hdr.value, mean, 1e-5);
}

TEST(HdrFlip, DoesNotChangeWithTheUnitOfLight) {
  const Image a = noise(16, 10, 3, 9), b = noise(16, 10, 3, 10);
  Image a8 = a, b8 = b;
  for (Image* image : {&a8, &b8}) {
    for (float& v : image->pixels) v *= 8;
  }
  EXPECT_NEAR(hdr_flip(a, b).value, hdr_flip(a8, b8).value, 1e-6);
  EXPECT_EQ(hdr_flip(constant(0, 0, 0), constant(0, 0, 0)).value, 0);
}

}  // namespace
}  // namespace capcon
