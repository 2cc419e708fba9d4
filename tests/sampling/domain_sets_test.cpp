#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "base/error.h"
#include "base/hash.h"
#include "points/ensemble.h"
#include "sampling/disk_turn.h"
#include "sampling/sampler.h"

namespace capcon {
namespace {

glm::dvec2 on_disk(FixedPoint p) {
  return into_domain(EnsembleDomain::disk, to_double(p));
}

TEST(DomainSets, RefusesMoreThanItCanMakeInWords) {
  try {
    make_sampler("capcon-domain", 1025, 1);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("take fewer samples, or sobol-owen"), std::string::npos);
  }
}

TEST(DomainSets, TurningIsARotationOfTheDisk) {
  const auto word = [](int i, int k) { return static_cast<std::uint32_t>(mix64(3, i, k)); };
  for (int i = 0; i < 20000; ++i) {
    FixedPoint p{word(i, 0), word(i, 1)};
    if (i % 4 == 0) p.y = p.x;               // diagonals
    if (i % 7 == 0) p = {0x80000000u, p.y};  // axes
    if (i % 11 == 0) p = {0u, p.y};          // the rim
    const std::uint32_t turn = i % 13 == 0 ? 0x40000000u * (i % 4) : word(i, 2);
    const double angle = 2 * std::numbers::pi * turn * 0x1p-32;
    const glm::dvec2 from = on_disk(p), to = on_disk(turn_in_square(p, turn));
    EXPECT_NEAR(to.x, std::cos(angle) * from.x - std::sin(angle) * from.y, 3e-7) << i;
    EXPECT_NEAR(to.y, std::sin(angle) * from.x + std::cos(angle) * from.y, 3e-7) << i;
  }
}

/// Mean squared error over pixels of an estimate of `f`, which the pixel's number turns into one of a family.
double mse(const char* sampler, std::uint32_t count, std::uint32_t dimension,
           const std::function<double(FixedPoint, std::uint32_t)>& f,
           const std::function<double(std::uint32_t)>& integral) {
  const auto points = make_sampler(sampler, count, 9);
  double sum = 0;
  constexpr std::uint32_t kPixels = 4000;
  for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
    double estimate = 0;
    for (std::uint32_t i = 0; i < count; ++i)
      estimate += f(points->sample(pixel, i, dimension, dimension == 0 ? SampleDomain::disk : SampleDomain::square), pixel) / count;
    sum += (estimate - integral(pixel)) * (estimate - integral(pixel));
  }
  return sum / kPixels;
}

double random(std::uint32_t pixel, int k) {
  return uniform64(77, pixel, k);
}

// Half-planes at random distances and directions; the area of the disk's part beyond distance d is acos(d) -
// d sqrt(1 - d^2).
TEST(DomainSets, HalfPlanesOnTheDiskErrLessThanOwens) {
  const auto inside = [](FixedPoint p, std::uint32_t pixel) {
    const double a = 2 * std::numbers::pi * random(pixel, 0), d = 2 * random(pixel, 1) - 1;
    const glm::dvec2 q = on_disk(p);
    return q.x * std::cos(a) + q.y * std::sin(a) > d ? 1.0 : 0.0;
  };
  const auto share = [](std::uint32_t pixel) {
    const double d = 2 * random(pixel, 1) - 1;
    return (std::acos(d) - d * std::sqrt(1 - d * d)) / std::numbers::pi;
  };
  for (const std::uint32_t count : {16u, 64u}) {
    EXPECT_LT(mse("capcon-domain", count, 0, inside, share), 0.8 * mse("sobol-owen", count, 0, inside, share))
        << count;
  }
}

// Half-planes through the unit square that are perpendicular to neither side: x + s y < t with its area in
// closed form.
TEST(DomainSets, HalfPlanesOnTheSquareErrLessThanOwens) {
  const auto slope = [](std::uint32_t pixel) { return 0.2 + 0.8 * random(pixel, 2); };
  const auto place = [&](std::uint32_t pixel) {
    return slope(pixel) + (1 - slope(pixel)) * random(pixel, 3);
  };
  const auto inside = [&](FixedPoint p, std::uint32_t pixel) {
    const glm::dvec2 q = to_double(p);
    return q.x + slope(pixel) * q.y < place(pixel) ? 1.0 : 0.0;
  };
  const auto share = [&](std::uint32_t pixel) { return place(pixel) - 0.5 * slope(pixel); };  // a trapezium
  EXPECT_LT(mse("capcon-domain", 64, 1, inside, share), 0.9 * mse("sobol-owen", 64, 1, inside, share));
}

}  // namespace
}  // namespace capcon
