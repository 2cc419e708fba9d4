// Ambient occlusion of a floor under a ball, which needs nothing of capcon's renderer: what its samplers and
// tiles are worth in a program of your own. Prints the error of a few samplers, and what a tile set holds.
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>

#include "capcon/sampler.h"
#include "capcon/tile_set.h"

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kHeight = 2, kRadius = 1;  // of the ball's centre above the floor, and of the ball

/// Whether a ray from (x, 0, 0) on the floor, whose direction is the cosine-weighted one of a point of the
/// square, misses the ball.
bool misses(double x, capcon::sampling::Point p) {
  // Shirley and Chiu's concentric map, then up to the hemisphere.
  const double a = 2 * p.x - 1, b = 2 * p.y - 1;
  const bool wide = std::abs(a) > std::abs(b);
  const double r = wide ? a : b,
               angle = wide ? kPi / 4 * (b / a) : kPi / 2 - (b != 0 ? kPi / 4 * (a / b) : 0);
  const double dx = r * std::cos(angle), dz = std::sqrt(std::fmax(0, 1 - r * r));
  // The ball's centre lies (-x, 0, kHeight) from the floor's point.
  const double along = -x * dx + kHeight * dz, square = x * x + kHeight * kHeight;
  return along < 0 || square - along * along > kRadius * kRadius;
}

/// Root mean squared error over many places and their sets. Occlusion by a ball wholly above the floor: (R /
/// d)^2 cos(theta).
double error_of(const std::string& name, std::uint32_t samples) {
  const capcon::sampling::Sampler sampler(name, samples);
  constexpr std::uint32_t kPixels = 1000;
  double sum = 0;
  for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
    const double x = 2.0 * pixel / kPixels, d2 = x * x + kHeight * kHeight;
    const double truth = 1 - kRadius * kRadius / d2 * (kHeight / std::sqrt(d2));
    double seen = 0;
    for (const capcon::sampling::Point p : sampler.set(pixel, 0, capcon::sampling::Domain::disk))
      seen += misses(x, p) ? 1 : 0;
    sum += (seen / samples - truth) * (seen / samples - truth);
  }
  return std::sqrt(sum / kPixels);
}

}  // namespace

int main() {
  try {
    std::printf("capcon %s\n", capcon::sampling::version().c_str());
    for (const char* name : {"random", "sobol-owen", "capcon", "capcon-domain"})
      std::printf("%-14s 64 samples: error %.4f\n", name, error_of(name, 64));
    const capcon::sampling::TileSet tiles;
    std::printf("%u tiles of %u points, a tiling of 4 x 4: %zu points\n", tiles.tiles(),
                tiles.points_per_tile(), tiles.tiling(4).size());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "occlusion: %s\n", error.what());
    return 1;
  }
}
