#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <set>

#include "base/error.h"
#include "tiling/tiling.h"

namespace capcon {
namespace {

using Shape = std::pair<std::uint32_t, std::uint32_t>;
const Shape kShapes[] = {{1, 0}, {1, 1}, {2, 0}, {2, 1}, {2, 2}, {3, 0}, {3, 1},  {3, 2},    {4, 0},
                         {4, 2}, {4, 4}, {6, 3}, {8, 0}, {8, 8}, {7, 5}, {12, 9}, {181, 180}};

std::complex<double> wrapped(std::complex<double> z) {
  return {z.real() - std::floor(z.real()), z.imag() - std::floor(z.imag())};
}

// Distance on the torus, in units of 2^-32.
double far(FixedPoint p, std::complex<double> z) {
  const auto one = [](std::uint32_t v, double w) {
    const double d = v * 0x1p-32 - w;
    return std::abs(d - std::round(d)) * 0x1p32;
  };
  return std::max(one(p.x, z.real()), one(p.y, z.imag()));
}

TEST(GaussianTiling, HasAsManyTilesAsTheNorm) {
  for (const auto& [a, b] : kShapes) EXPECT_EQ(GaussianTiling(a, b).size(), a * a + b * b);
  EXPECT_THROW(GaussianTiling(0, 0), InputError);
  EXPECT_THROW(GaussianTiling(1, 2), InputError);
  EXPECT_THROW(GaussianTiling(40000, 0), InputError);
}

TEST(GaussianTiling, IndexIsABijectionThatWrapsWithTheLattice) {
  for (const auto& [a, b] : kShapes) {
    const GaussianTiling tiling(a, b);
    const std::int64_t A = a, B = b;
    for (std::uint32_t i = 0; i < tiling.size(); ++i) {
      const glm::ivec2 c = tiling.cell(i);
      ASSERT_EQ(tiling.index(c.x, c.y), i);
      ASSERT_EQ(tiling.index(c.x + A, c.y + B), i);
      ASSERT_EQ(tiling.index(c.x - 3 * B, c.y + 3 * A), i);
      ASSERT_EQ(tiling.index(c.x - 100 * A, c.y - 100 * B), i);
    }
  }
}

TEST(GaussianTiling, NeighboursShareVertices) {
  for (const auto& [a, b] : kShapes) {
    const GaussianTiling tiling(a, b);
    for (std::uint32_t i = 0; i < tiling.size(); ++i) {
      const glm::ivec2 c = tiling.cell(i);
      const auto here = tiling.corners(i), right = tiling.corners(tiling.index(c.x + 1, c.y)),
                 above = tiling.corners(tiling.index(c.x, c.y + 1));
      ASSERT_EQ(here[0], i);
      ASSERT_EQ(here[1], right[0]);
      ASSERT_EQ(here[3], right[2]);
      ASSERT_EQ(here[2], above[0]);
      ASSERT_EQ(here[3], above[1]);
    }
  }
}

TEST(GaussianTiling, OriginsAndPlacesAreComplexDivision) {
  for (const auto& [a, b] : kShapes) {
    const GaussianTiling tiling(a, b);
    const std::complex<double> whole(a, b);
    std::set<std::pair<std::uint32_t, std::uint32_t>> distinct;
    for (std::uint32_t i = 0; i < tiling.size(); ++i) {
      const glm::ivec2 c = tiling.cell(i);
      const FixedPoint origin = tiling.origin(i);
      ASSERT_LE(far(origin, wrapped(std::complex<double>(c.x, c.y) / whole)), 1.0);
      distinct.insert({origin.x, origin.y});
      const FixedPoint p{2654435761u * (i + 1), 0x9e3779b9u ^ (i * 40503u)};
      const std::complex<double> z(p.x * 0x1p-32, p.y * 0x1p-32);
      ASSERT_LE(far(tiling.place(p), wrapped(z / whole)), 1.0);
    }
    EXPECT_EQ(distinct.size(), tiling.size());
  }
}

// Every place of the torus lies in exactly one cell: a half-open tile moved to the cells' origins covers it
// once.
TEST(GaussianTiling, CellsCoverTheTorusOnce) {
  for (const auto& [a, b] : kShapes) {
    if (a > 20) continue;
    const GaussianTiling tiling(a, b);
    const std::complex<double> whole(a, b);
    for (int k = 0; k < 200; ++k) {
      const std::complex<double> place(std::fmod(0.1234567 + k * 0.6180339887, 1),
                                       std::fmod(0.7654321 + k * 0.7548776662, 1));
      int covers = 0;
      for (std::uint32_t i = 0; i < tiling.size(); ++i) {
        const glm::dvec2 origin = to_double(tiling.origin(i));
        bool inside = false;
        for (int dx = -1; dx <= 1; ++dx)
          for (int dy = -1; dy <= 1; ++dy) {
            const std::complex<double> z =
                (place - std::complex<double>(origin.x + dx, origin.y + dy)) * whole;
            inside = inside || (z.real() >= 0 && z.real() < 1 && z.imag() >= 0 && z.imag() < 1);
          }
        covers += inside;
      }
      ASSERT_EQ(covers, 1) << a << "+" << b << "i";
    }
  }
}

TEST(TilePoints, AreWhatComplexArithmeticGives) {
  const TileSet set = shipped_tile_set();
  for (const auto& [a, b] : {Shape{1, 0}, Shape{1, 1}, Shape{2, 1}, Shape{4, 0}, Shape{4, 4}}) {
    const GaussianTiling tiling(a, b);
    const auto colours = random_colours(tiling, 2, 42);
    for (const std::uint32_t ranks : {1u, 5u, 16u}) {
      const Points points = tile_points(set, tiling, colours, ranks);
      ASSERT_EQ(points.size(), tiling.size() * ranks);
      for (std::uint32_t cell = 0; cell < tiling.size(); ++cell) {
        const glm::ivec2 c = tiling.cell(cell);
        const std::uint32_t tile = colours[tiling.index(c.x, c.y)] + 2 * colours[tiling.index(c.x + 1, c.y)] +
                                   4 * colours[tiling.index(c.x, c.y + 1)] +
                                   8 * colours[tiling.index(c.x + 1, c.y + 1)];
        for (std::uint32_t r = 0; r < ranks; ++r) {
          const glm::dvec2 in_tile = to_double(set.tiles[tile][r].position);
          const auto z =
              wrapped(std::complex<double>(c.x + in_tile.x, c.y + in_tile.y) / std::complex<double>(a, b));
          ASSERT_LE(far(to_fixed(points[cell * ranks + r]), z), 3.0);
        }
      }
    }
  }
}

TEST(RandomColours, DependOnTheSeedAndAreEven) {
  const GaussianTiling tiling(64, 0);
  const auto one = random_colours(tiling, 3, 1), two = random_colours(tiling, 3, 2);
  EXPECT_NE(one, two);
  EXPECT_EQ(one, random_colours(tiling, 3, 1));
  int count[3] = {};
  for (const std::uint32_t c : one) ++count[c];
  for (const int c : count) EXPECT_NEAR(c, 4096 / 3.0, 4 * std::sqrt(4096 * 2 / 9.0));
}

}  // namespace
}  // namespace capcon
