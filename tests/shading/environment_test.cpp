#include "shading/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "base/hash.h"
#include "shading/spectrum.h"

namespace capcon {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr SphereMap kMaps[] = {SphereMap::lat_long, SphereMap::octahedral};

glm::dvec2 random_point(std::uint64_t seed, std::uint64_t i) {
  return {uniform64(seed, 0, i), uniform64(seed, 1, i)};
}

/// Uniform on the sphere.
glm::dvec3 random_direction(std::uint64_t seed, std::uint64_t i) {
  const glm::dvec2 u = random_point(seed, i);
  const double z = 1 - 2 * u.x, ring = std::sqrt(1 - z * z);
  return {ring * std::cos(2 * kPi * u.y), ring * std::sin(2 * kPi * u.y), z};
}

Image noise(int width, int height, double sharpness) {
  Image image(width, height, 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<float>(std::pow(uniform64(7, 0, i), sharpness));
  return image;
}

TEST(SphereMap, KnownDirections) {
  const auto near = [](const glm::dvec2& a, double u, double v) {
    EXPECT_NEAR(a.x, u, 1e-12);
    EXPECT_NEAR(a.y, v, 1e-12);
  };
  near(square_of_direction(SphereMap::lat_long, {1, 0, 0}), 0, 0.5);
  near(square_of_direction(SphereMap::lat_long, {0, 1, 0}), 0.25, 0.5);
  near(square_of_direction(SphereMap::lat_long, {0, -1, 0}), 0.75, 0.5);
  EXPECT_EQ(square_of_direction(SphereMap::lat_long, {0, 0, 1}).y, 0);
  EXPECT_EQ(square_of_direction(SphereMap::lat_long, {0, 0, -1}).y, 1);
  near(square_of_direction(SphereMap::octahedral, {0, 0, 1}), 0.5, 0.5);
  near(square_of_direction(SphereMap::octahedral, {1, 0, 0}), 1, 0.5);
  near(square_of_direction(SphereMap::octahedral, {0, 1, 0}), 0.5, 1);
  EXPECT_NEAR(direction_of_square(SphereMap::octahedral, {1, 1}).z, -1, 1e-12);
  EXPECT_LT(square_of_direction(SphereMap::lat_long, {1, -1e-300, 0}).x, 1);
}

TEST(SphereMap, ThereAndBack) {
  for (const SphereMap map : kMaps) {
    for (int i = 0; i < 1000; ++i) {
      const glm::dvec3 direction = random_direction(1, i);
      const glm::dvec2 square = square_of_direction(map, direction);
      EXPECT_TRUE(square.x >= 0 && square.x <= 1 && square.y >= 0 && square.y <= 1);
      EXPECT_NEAR(glm::distance(direction_of_square(map, square), direction), 0, 1e-7);
    }
  }
}

TEST(SphereMap, OctahedralKeepsAreas) {
  for (int i = 0; i < 200; ++i) {
    const glm::dvec2 p = 0.001 + 0.998 * random_point(2, i);
    const double step = 1e-5;
    const auto at = [&](double x, double y) {
      return direction_of_square(SphereMap::octahedral, p + glm::dvec2(x, y));
    };
    const auto crease = [&](double t) { return std::abs(t) < 1e-3; };  // the map has creases there
    const double x = 2 * p.x - 1, y = 2 * p.y - 1;
    if (crease(x) || crease(y) || crease(1 - std::abs(x) - std::abs(y))) continue;
    const glm::dvec3 du = (at(step, 0) - at(-step, 0)) / (2 * step),
                     dv = (at(0, step) - at(0, -step)) / (2 * step);
    EXPECT_NEAR(glm::length(glm::cross(du, dv)), 4 * kPi, 1e-3);
  }
}

TEST(SphereMap, NeighboursBeyondTheEdgesAreNeighboursOnTheSphere) {
  constexpr int n = 32;
  Image image(n, n, 3);
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const glm::dvec3 d = direction_of_square(SphereMap::octahedral, {(x + 0.5) / n, (y + 0.5) / n});
      for (int c = 0; c < 3; ++c) image.at(x, y, c) = static_cast<float>(d[c] + 2);
    }
  }
  for (int i = 0; i < n; ++i) {
    const auto inside = [&](int x, int y) { return sphere_texel(SphereMap::octahedral, image, x, y); };
    EXPECT_LT(glm::distance(inside(-1, i), inside(0, i)), 0.3);
    EXPECT_LT(glm::distance(inside(n, i), inside(n - 1, i)), 0.3);
    EXPECT_LT(glm::distance(inside(i, -1), inside(i, 0)), 0.3);
    EXPECT_LT(glm::distance(inside(i, n), inside(i, n - 1)), 0.3);
  }
  for (int i = 0; i < 500; ++i) {  // so that a lookup of the direction gives the direction
    const glm::dvec3 d = random_direction(3, i);
    EXPECT_LT(glm::distance(sphere_lookup(SphereMap::octahedral, image, d) - 2.0, d), 0.1);
  }
}

TEST(SphereMap, OctahedralLookupsHaveNoSeams) {
  const Image image = noise(8, 8, 1);
  const auto at = [&](double u, double v) {
    return sphere_lookup(SphereMap::octahedral, image, direction_of_square(SphereMap::octahedral, {u, v})).r;
  };
  // An edge is folded at its middle: (0, v) and (0, 1 - v) are one direction.
  for (double t = 0.03; t < 0.5; t += 0.04) {
    for (const double edge : {1e-9, 1 - 1e-9}) {
      EXPECT_NEAR(at(edge, t), at(edge, 1 - t), 1e-6);
      EXPECT_NEAR(at(t, edge), at(1 - t, edge), 1e-6);
    }
  }
}

TEST(SphereMap, LookupsAreBilinear) {
  Image image(4, 2, 1);
  image.pixels = {1, 2, 3, 4, 5, 6, 7, 8};
  const auto at = [&](double u, double v) {
    return sphere_lookup(SphereMap::lat_long, image, direction_of_square(SphereMap::lat_long, {u, v})).g;
  };
  EXPECT_NEAR(at(0.375, 0.25), 2, 1e-12);
  EXPECT_NEAR(at(0.5, 0.25), 2.5, 1e-12);
  EXPECT_NEAR(at(0.375, 0.5), 4, 1e-12);
  EXPECT_NEAR(at(1e-9, 0.25), 2.5, 1e-6);  // between the last column and the first
  EXPECT_NEAR(at(0.375, 0.01), 2, 1e-12);  // the row at the pole goes on
  image.pixels[1] = std::nanf("");
  image.pixels[2] = -5;
  EXPECT_EQ(at(0.375, 0.25), 0);
  EXPECT_EQ(at(0.625, 0.25), 0);
}

TEST(Environment, DensityIntegratesToOne) {
  const int sizes[][2] = {{1, 1}, {2, 1}, {1, 3}, {7, 5}, {64, 32}};
  for (const SphereMap map : kMaps) {
    for (const auto& size : sizes) {
      const int w = size[0], h = map == SphereMap::octahedral ? size[0] : size[1];
      const EnvironmentTable table = tabulate_environment(noise(w, h, 4), map);
      // Over a fine grid of texel centres, by the solid angles of its cells.
      const int fine_w = w * 4, fine_h = h * 4;
      double sum = 0;
      for (int y = 0; y < fine_h; ++y) {
        for (int x = 0; x < fine_w; ++x) {
          sum += environment_pdf(table, direction_of_square(map, {(x + 0.5) / fine_w, (y + 0.5) / fine_h})) *
                 texel_solid_angle(map, fine_w, fine_h, y);
        }
      }
      EXPECT_NEAR(sum, 1, 1e-9) << w << " x " << h;
    }
  }
}

TEST(Environment, SamplesHaveTheDensityOfTheirDirection) {
  for (const SphereMap map : kMaps) {
    const EnvironmentTable table =
        tabulate_environment(noise(16, map == SphereMap::octahedral ? 16 : 8, 6), map);
    int edges = 0;
    for (int i = 0; i < 5000; ++i) {
      const EnvironmentSample sample = sample_environment(table, random_point(4, i));
      EXPECT_NEAR(glm::length(sample.direction), 1, 1e-12);
      EXPECT_GT(sample.pdf, 0);
      const double pdf = environment_pdf(table, sample.direction);
      edges += std::abs(pdf / sample.pdf - 1) > 1e-9;  // rounding to the other side of a texel's edge
    }
    EXPECT_LE(edges, 1);
  }
}

/// Chi-square of the texels that samples fall into against luminance x solid angle, worked out here.
TEST(Environment, SamplesFollowTheWeights) {
  for (const SphereMap map : kMaps) {
    const int w = 12, h = map == SphereMap::octahedral ? 12 : 6;
    const Image image = noise(w, h, 2);
    const EnvironmentTable table = tabulate_environment(image, map);
    // The weight of a texel by averaging the lookup over it, on a grid.
    std::vector<double> weights(w * h);
    double total = 0;
    for (int y = 0; y < h; ++y) {
      for (int x = 0; x < w; ++x) {
        const int n = 32;
        double mean = 0;
        for (int j = 0; j < n * n; ++j) {
          const glm::dvec2 square((x + (j % n + 0.5) / n) / w, (y + (j / n + 0.5) / n) / h);
          mean += luminance(sphere_lookup(map, image, direction_of_square(map, square))) / (n * n);
        }
        weights[y * w + x] = mean * texel_solid_angle(map, w, h, y);
        total += weights[y * w + x];
      }
    }
    EXPECT_NEAR(luminance(table.integral) / total, 1, 1e-3);
    const int count = 200000;
    std::vector<int> hits(w * h);
    for (int i = 0; i < count; ++i) {
      const glm::dvec2 square =
          square_of_direction(map, sample_environment(table, random_point(5, i)).direction);
      const int x = std::min(static_cast<int>(square.x * w), w - 1),
                y = std::min(static_cast<int>(square.y * h), h - 1);
      ++hits[y * w + x];
    }
    double chi = 0;
    for (int i = 0; i < w * h; ++i) {
      const double expected = weights[i] / total * count;
      chi += (hits[i] - expected) * (hits[i] - expected) / expected;
    }
    const double freedom = w * h - 1;
    EXPECT_LT(chi, freedom + 4 * std::sqrt(2 * freedom));
  }
}

TEST(Environment, OneBrightTexel) {
  Image image(64, 32, 3);
  std::fill(image.pixels.begin(), image.pixels.end(), 1.f);
  for (int c = 0; c < 3; ++c) image.at(40, 10, c) = 1e8f;
  const EnvironmentTable table = tabulate_environment(image, SphereMap::lat_long);
  int bright = 0;
  for (int i = 0; i < 10000; ++i) {
    const EnvironmentSample sample = sample_environment(table, random_point(6, i));
    EXPECT_TRUE(std::isfinite(sample.pdf) && sample.pdf > 0);
    const glm::dvec2 square = square_of_direction(SphereMap::lat_long, sample.direction);
    // Bilinear lookups carry its light half a texel further.
    bright += std::abs(square.x * 64 - 40.5) <= 1.5 && std::abs(square.y * 32 - 10.5) <= 1.5;
  }
  EXPECT_GT(bright, 9990);
  for (int i = 0; i < 1000; ++i)
    EXPECT_GT(environment_pdf(table, random_direction(7, i)), 0);  // none is forgotten
  const double texel = texel_solid_angle(SphereMap::lat_long, 64, 32, 10);
  EXPECT_NEAR(table.integral.g / (1e8 * texel), 1, 0.02);
}

TEST(Environment, BlackAndConstantMapsAreUniform) {
  for (const SphereMap map : kMaps) {
    for (const float value : {0.f, 3.f}) {
      Image image(20, map == SphereMap::octahedral ? 20 : 10, 3);
      std::fill(image.pixels.begin(), image.pixels.end(), value);
      const EnvironmentTable table = tabulate_environment(image, map);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(table.integral[c], 4 * kPi * value, 1e-9);
      for (int i = 0; i < 200; ++i) {
        EXPECT_NEAR(environment_pdf(table, random_direction(8, i)) * 4 * kPi, 1, 1e-4);
        EXPECT_NEAR(sample_environment(table, random_point(8, i)).pdf * 4 * kPi, 1, 1e-4);
      }
    }
  }
}

TEST(Environment, BlackTexelsAreNeverSampled) {
  Image image(8, 4, 3);
  for (int c = 0; c < 3; ++c) image.at(2, 1, c) = 1;
  const EnvironmentTable table = tabulate_environment(image, SphereMap::lat_long);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 direction = sample_environment(table, random_point(9, i)).direction;
    const glm::dvec2 square = square_of_direction(SphereMap::lat_long, direction);
    EXPECT_TRUE(square.x * 8 > 1 - 1e-9 && square.x * 8 < 4 + 1e-9 && square.y * 4 < 3 + 1e-9);
  }
  EXPECT_EQ(environment_pdf(table, direction_of_square(SphereMap::lat_long, {0.9, 0.9})), 0);
}

/// Points of 24 bits hit each texel exactly as often as its probability says.
TEST(Environment, ProbabilitiesAreThoseOfTheGrid) {
  const EnvironmentTable table = tabulate_environment(noise(9, 1, 8), SphereMap::lat_long);
  std::map<std::uint32_t, std::uint32_t> hits;
  const std::uint32_t step = 1 << 6;  // every 64th point, and the sums' own ends beside
  for (std::uint32_t i = 0; i < EnvironmentTable::kUnit; i += step) {
    const double x = static_cast<double>(i) / EnvironmentTable::kUnit;
    const glm::dvec3 direction = sample_environment(table, {x, 0.5}).direction;
    ++hits[static_cast<std::uint32_t>(square_of_direction(SphereMap::lat_long, direction).x * 9)];
  }
  for (std::uint32_t cell = 0; cell < 9; ++cell) {
    const double units = table.columns[cell + 1] - table.columns[cell];
    EXPECT_NEAR(hits[cell], units / step, 1.001) << cell;
  }
  EXPECT_EQ(table.columns.back(), EnvironmentTable::kUnit);
}

TEST(Environment, TheGuideHoldsEveryCell) {
  // Extreme weights in odd numbers of cells: the search must end in the cell whose sums enclose the value.
  for (const int width : {1, 3, 4, 5, 17, 1000}) {
    Image image(width, 3, 1);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      image.pixels[i] = static_cast<float>(std::pow(10, 12 * uniform64(11, 0, i) - 6));
    const EnvironmentTable table = tabulate_environment(image, SphereMap::lat_long);
    for (int i = 0; i < 2000; ++i) {
      glm::dvec2 point = random_point(12, i);
      if (i == 0) point = {0, 0};
      if (i == 1) point = glm::dvec2(std::nextafter(1.0, 0.0));
      const EnvironmentSample sample = sample_environment(table, point);
      ASSERT_TRUE(std::isfinite(sample.pdf) && sample.pdf > 0);
      // A plain search over all sums says the same.
      const double y = point.y * EnvironmentTable::kUnit, x = point.x * EnvironmentTable::kUnit;
      const auto row = std::upper_bound(table.rows.begin(), table.rows.end(), y) - 1;
      const auto sums = table.columns.begin() + (row - table.rows.begin()) * (width + 1);
      const auto column = std::upper_bound(sums, sums + width + 1, x) - 1;
      const double u = ((column - sums) + (x - *column) / (column[1] - *column)) / width;
      ASSERT_NEAR(square_of_direction(SphereMap::lat_long, sample.direction).x, u, 1e-9);
    }
  }
}

}  // namespace
}  // namespace capcon
