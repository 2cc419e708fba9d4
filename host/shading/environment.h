#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "image/image.h"
#include "shading/sphere_map.h"

namespace capcon {

/// Importance of the texels of an environment map: a marginal distribution over rows and a conditional one
/// over the columns of each row, as cumulative sums in units of 2^-24. Probabilities are multiples of that
/// unit, so that sample points of 24 bits hit each texel with exactly the probability that pdf() says, in
/// float and in double. Every texel of positive weight has at least one unit.
///
/// Inversion keeps neighbouring sample points together, which an alias table (one load) would tear apart:
/// this is a program about point sets. A guide (Chen and Asau 1974) of an entry for kCellsPerGuide cells
/// leaves a search over few cells: about 5 loads for each of row and column on the maps of the measurements,
/// see docs/materials.md.
struct EnvironmentTable {
  static constexpr std::uint32_t kUnit = 1u << 24;  ///< all of the probability
  static constexpr int kCellsPerGuide = 4;

  SphereMap map = SphereMap::lat_long;
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> rows;          ///< height + 1 sums, from 0 to kUnit
  std::vector<std::uint32_t> columns;       ///< for each row width + 1 sums, from 0 to kUnit
  std::vector<std::uint32_t> row_guide;     ///< guide_size(height) + 1 first cells, the last one height
  std::vector<std::uint32_t> column_guide;  ///< for each row guide_size(width) + 1
  glm::dvec3 integral{0};                   ///< of the radiance over all directions; 0: the map is black

  static int guide_size(int cells) { return (cells + kCellsPerGuide - 1) / kCellsPerGuide; }
};

/// The table of an image: the weight of a texel is the luminance of the bilinear lookup, averaged over the
/// texel in the image, times its solid angle. A black map gets the uniform distribution over the sphere.
/// InputError for images with a side of more than 2^22 texels.
EnvironmentTable tabulate_environment(const Image& image, SphereMap map);

struct EnvironmentSample {
  glm::dvec3 direction;  ///< unit, in the light's space
  double pdf = 0;        ///< in solid angle
};

/// A direction by a point of [0, 1)^2: x chooses the column, y the row; within its texel uniform in solid
/// angle.
EnvironmentSample sample_environment(const EnvironmentTable& table, const glm::dvec2& point);

/// Density in solid angle towards a unit direction: the probability of its texel / solid angle of the texel.
double environment_pdf(const EnvironmentTable& table, const glm::dvec3& direction);

}  // namespace capcon
