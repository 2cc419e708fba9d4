#include "points/generators.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "base/error.h"
#include "base/hash.h"
#include "points/ccvt.h"
#include "points/halton.h"
#include "points/lloyd.h"
#include "points/region_ccvt.h"
#include "points/sobol.h"

namespace capcon {

namespace {

enum Stream : std::uint64_t { kJitter = 2, kDigits, kOwenX, kOwenY, kHalton2, kHalton3 };

Points jittered_points(const GeneratorOptions& options) {
  // As many rows as make the strata most nearly square. The n points are shared out over the rows evenly, and
  // each row is cut into as many strata as it has points; all strata have the area 1/n. For n = a b with a
  // near b this is the a x b grid; for a prime n the rows differ by one stratum.
  const std::uint32_t n = options.n;
  auto rows = static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(n))));
  for (std::uint32_t a = rows; a >= 1 && 2 * a >= rows; --a) {
    if (n % a == 0) {
      rows = a;
      break;
    }
  }
  Points points;
  points.reserve(n);
  for (std::uint64_t row = 0; row < rows; ++row) {
    const std::uint64_t first = row * n / rows, last = (row + 1) * n / rows;
    for (std::uint64_t i = first; i < last; ++i) {
      const double u = uniform64(options.seed, kJitter, 2 * i),
                   v = uniform64(options.seed, kJitter, 2 * i + 1);
      const double x = (static_cast<double>(i - first) + u) / static_cast<double>(last - first);
      const double y = (static_cast<double>(first) + v * static_cast<double>(last - first)) / n;
      points.emplace_back(x < 1 ? x : 0, y < 1 ? y : 0);
    }
  }
  place_all(options.region, points);
  return points;
}

template <class Scramble>
Points sobol_points(std::uint32_t n, const Scramble& scramble) {
  Points points(n);
  for (std::uint32_t i = 0; i < n; ++i) points[i] = glm::dvec2(scramble(sobol_x(i), sobol_y(i))) * 0x1p-32;
  return points;
}

struct Method {
  const char* name;
  Points (*generate)(const GeneratorOptions&);
  bool any_region = false;
};

const Method kMethods[] = {
    {"random", [](const GeneratorOptions& o) { return random_points(o.region, o.n, o.seed); }, true},
    {"jittered", jittered_points, true},
    {"sobol",
     [](const GeneratorOptions& o) {
       return sobol_points(o.n, [](std::uint32_t x, std::uint32_t y) { return glm::uvec2(x, y); });
     }},
    {"sobol-xor",
     [](const GeneratorOptions& o) {
       const std::uint64_t digits = mix64(o.seed, kDigits, 0);
       const glm::uvec2 flips(static_cast<std::uint32_t>(digits >> 32), static_cast<std::uint32_t>(digits));
       return sobol_points(o.n, [&](std::uint32_t x, std::uint32_t y) { return glm::uvec2(x, y) ^ flips; });
     }},
    {"sobol-owen",
     [](const GeneratorOptions& o) {
       return sobol_points(o.n, [&](std::uint32_t x, std::uint32_t y) {
         return glm::uvec2(owen_scrambled(x, o.seed, kOwenX), owen_scrambled(y, o.seed, kOwenY));
       });
     }},
    {"halton",
     [](const GeneratorOptions& o) {
       Points points(o.n);
       for (std::uint32_t i = 0; i < o.n; ++i) points[i] = {radical_inverse(i, 2), radical_inverse(i, 3)};
       return points;
     }},
    {"halton-scrambled",
     [](const GeneratorOptions& o) {
       Points points(o.n);
       for (std::uint32_t i = 0; i < o.n; ++i) {
         points[i] = {owen_radical_inverse(i, 2, o.seed, kHalton2),
                      owen_radical_inverse(i, 3, o.seed, kHalton3)};
       }
       return points;
     }},
    {"lattice",
     [](const GeneratorOptions& o) {
       Points points = lattice_points(o.kind, o.n);
       if (o.shift) shift_randomly(points, o.seed);
       return points;
     }},
    {"lloyd",
     [](const GeneratorOptions& o) {
       return lloyd({o.n, o.seed, o.rounds, o.region, o.on_progress});
     },
     true},
    {"fpo",
     [](const GeneratorOptions& o) {
       return fpo({o.n, o.seed, o.strategy, o.on_progress});
     }},
    {"ccvt",
     [](const GeneratorOptions& o) {
       CcvtOptions ccvt_options;
       ccvt_options.sites = o.n;
       ccvt_options.capacity = o.capacity;
       ccvt_options.seed = o.seed;
       ccvt_options.on_progress = o.on_progress;
       ccvt_options.stop = o.stop;
       ccvt_options.finish = o.finish;
       return o.region.is_plain_torus() ? ccvt(ccvt_options).points : region_ccvt(o.region, ccvt_options);
     },
     true},
};

}  // namespace

const std::vector<std::string>& generator_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Method& method : kMethods) list.emplace_back(method.name);
    return list;
  }();
  return names;
}

Points generate(std::string_view method, const GeneratorOptions& options) {
  if (options.n == 0) throw InputError("a point set needs at least one point (n >= 1)");
  for (const Method& known : kMethods) {
    if (method != known.name) continue;
    if (!known.any_region && !options.region.is_plain_torus()) {
      throw InputError(
          fmt::format("{} fills the whole torus evenly; random, jittered, lloyd and ccvt take densities and "
                      "other domains",
                      method));
    }
    return known.generate(options);
  }
  throw InputError(fmt::format("no method \"{}\"; there are {}", method, fmt::join(generator_names(), ", ")));
}

}  // namespace capcon
