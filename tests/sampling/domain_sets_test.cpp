#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "base/error.h"
#include "base/hash.h"
#include "points/ensemble.h"
#include "sampling/sampler.h"

namespace capcon {
namespace {

glm::dvec2 on_disk(FixedPoint p) {
  return into_domain(EnsembleDomain::disk, to_double(p));
}

TEST(DomainSets, RefusesWhatItCannotMakeInWords) {
  for (const auto& [count, words] :
       {std::pair(4097u, "take fewer samples, or sobol-owen"), {2038u, "multiple of 64 such as 2048"}}) {
    try {
      make_sampler("capcon-domain", count, 1);
      FAIL() << count;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }
  for (std::uint32_t count = 1024; count <= 4096; count += 64) EXPECT_TRUE(can_make_ensemble(count)) << count;
}

/// Mean squared error over pixels of an estimate of `f`, which the pixel's number turns into one of a family.
double mse(const char* sampler, std::uint32_t count, SampleDomain domain,
           const std::function<double(FixedPoint, std::uint32_t)>& f,
           const std::function<double(std::uint32_t)>& integral) {
  const auto points = make_sampler(sampler, count, 9);
  double sum = 0;
  constexpr std::uint32_t kPixels = 4000;
  for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
    double estimate = 0;
    for (std::uint32_t i = 0; i < count; ++i)
      estimate += f(points->sample(pixel, i, 3, domain), pixel) / count;
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
    EXPECT_LT(mse("capcon-domain", count, SampleDomain::disk, inside, share),
              0.8 * mse("sobol-owen", count, SampleDomain::disk, inside, share))
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
  EXPECT_LT(mse("capcon-domain", 64, SampleDomain::square, inside, share),
            0.9 * mse("sobol-owen", 64, SampleDomain::square, inside, share));
}

// Caps of the sphere, which azimuth and height are equal-area coordinates of (Archimedes): half-spaces that
// cut the seam as likely as not. The share of a cap beyond distance d of the centre is (1 - d) / 2.
TEST(DomainSets, CapsOfTheSphereErrLessThanOwens) {
  const auto inside = [](FixedPoint p, std::uint32_t pixel) {
    const glm::dvec2 u = to_double(p);
    const double z = 2 * u.y - 1, r = std::sqrt(1 - z * z), angle = 2 * std::numbers::pi * u.x;
    const double pole = 2 * random(pixel, 5) - 1, across = std::sqrt(1 - pole * pole),
                 turn = 2 * std::numbers::pi * random(pixel, 6);
    return r * across * std::cos(angle - turn) + z * pole > 2 * random(pixel, 7) - 1 ? 1.0 : 0.0;
  };
  const auto share = [](std::uint32_t pixel) { return 1 - random(pixel, 7); };
  for (const std::uint32_t count : {16u, 64u}) {
    EXPECT_LT(mse("capcon-domain", count, SampleDomain::cylinder, inside, share),
              0.8 * mse("sobol-owen", count, SampleDomain::cylinder, inside, share))
        << count;
  }
}

// For two points half-planes leave a choice, of which the worst is a point and its mirror image in the
// middle: blind to whatever is round.
TEST(DomainSets, TwoPointsErrLessThanOwens) {
  const auto inside = [](FixedPoint p, std::uint32_t pixel) {
    const glm::dvec2 q = on_disk(p);
    return std::hypot(q.x, q.y) < random(pixel, 8) ? 1.0 : 0.0;
  };
  const auto share = [](std::uint32_t pixel) { return random(pixel, 8) * random(pixel, 8); };
  EXPECT_LT(mse("capcon-domain", 2, SampleDomain::disk, inside, share),
            0.9 * mse("sobol-owen", 2, SampleDomain::disk, inside, share));
}

// Whatever the domain's symmetry: chi-square over 8 x 8 cells, 121 is its 0.99999 quantile for 63 degrees of
// freedom.
TEST(DomainSets, EveryPointIsUniformInEveryDomain) {
  const auto sampler = make_sampler("capcon-domain", 16, 5, 4);
  for (const SampleDomain domain : {SampleDomain::square, SampleDomain::disk, SampleDomain::cylinder}) {
    for (const std::uint32_t index : {0u, 7u, 15u}) {
      std::array<int, 64> cells{};
      constexpr int kPixels = 64000;
      for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
        const FixedPoint p = sampler->sample(pixel, index, 3, domain);
        ++cells[(p.x >> 29) * 8 + (p.y >> 29)];
      }
      double chi2 = 0;
      for (const int c : cells) chi2 += (c - kPixels / 64.0) * (c - kPixels / 64.0) / (kPixels / 64.0);
      EXPECT_LT(chi2, 121) << static_cast<int>(domain) << " index " << index;
    }
  }
}

}  // namespace
}  // namespace capcon
