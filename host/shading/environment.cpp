#include "shading/environment.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"
#include "shading/spectrum.h"

namespace capcon {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kLongestSide = 1 << 22;
constexpr std::uint32_t kUnit = EnvironmentTable::kUnit;

/// Cumulative sums in units; a positive weight gets at least one. All zero: even parts.
void accumulate(std::span<const double> weights, std::span<std::uint32_t> sums) {
  double total = 0;
  std::uint32_t positive = 0;
  for (const double weight : weights) total += weight, positive += weight > 0;
  const double spare = kUnit - positive;
  double before = 0;
  std::uint32_t units = 0;
  sums[0] = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    before += weights[i];
    units += weights[i] > 0;
    const double part = total > 0 ? before / total * spare
                                  : static_cast<double>(i + 1) / static_cast<double>(weights.size()) * kUnit;
    sums[i + 1] = units + static_cast<std::uint32_t>(std::lround(std::min(part, total > 0 ? spare : kUnit)));
  }
}

/// Where the search for a value in part g of the guide starts: the cell that holds the part's first value.
void guide(std::span<const std::uint32_t> sums, std::span<std::uint32_t> first) {
  const std::size_t parts = first.size() - 1, cells = sums.size() - 1;
  std::uint32_t cell = 0;
  for (std::size_t g = 0; g < parts; ++g) {
    const std::uint64_t start = (static_cast<std::uint64_t>(g) * kUnit + parts - 1) / parts;
    while (cell + 1 < cells && sums[cell + 1] <= start) ++cell;
    first[g] = cell;
  }
  first[parts] = static_cast<std::uint32_t>(cells);
}

/// A cell chosen by x in [0, 1), and the position within the cell in [0, 1).
struct Choice {
  std::uint32_t cell;
  double within;
};

Choice choose(std::span<const std::uint32_t> sums, std::span<const std::uint32_t> first, double x) {
  const std::size_t parts = first.size() - 1;
  const double value = std::clamp(x, 0.0, std::nextafter(1.0, 0.0)) * kUnit;
  const std::size_t part = static_cast<std::size_t>(std::floor(value) * static_cast<double>(parts) / kUnit);
  std::uint32_t low = first[part];
  std::uint32_t high = std::min<std::uint32_t>(first[part + 1], static_cast<std::uint32_t>(sums.size() - 2));
  while (low < high) {  // the first cell whose sum is above the value
    const std::uint32_t middle = (low + high) / 2;
    if (sums[middle + 1] > value) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return {low, (value - sums[low]) / (sums[low + 1] - sums[low])};
}

template <typename Table>
auto row_sums(Table& table, std::size_t y) {
  return std::span(table.columns).subspan(y * (table.width + 1), table.width + 1);
}

template <typename Table>
auto row_guide(Table& table, std::size_t y) {
  const std::size_t size = EnvironmentTable::guide_size(table.width) + 1;
  return std::span(table.column_guide).subspan(y * size, size);
}

/// Mean of the bilinear lookup over a texel: 1/8, 3/4, 1/8 along each axis.
glm::dvec3 mean_over_texel(const Image& image, SphereMap map, int x, int y) {
  constexpr double kPart[3] = {0.125, 0.75, 0.125};
  glm::dvec3 sum(0);
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) sum += kPart[i + 1] * kPart[j + 1] * sphere_texel(map, image, x + i, y + j);
  }
  return sum;
}

/// The same for a whole row, in two passes where neighbours lie side by side: a third of the work.
std::vector<glm::dvec3> means_over_row(const Image& image, SphereMap map, int y) {
  const int w = image.width;
  std::vector<glm::dvec3> means(w);
  const bool folded = map == SphereMap::octahedral && (y == 0 || y == image.height - 1);
  if (folded || w < 2) {
    for (int x = 0; x < w; ++x) means[x] = mean_over_texel(image, map, x, y);
    return means;
  }
  std::vector<glm::dvec3> across(w);
  for (int x = 0; x < w; ++x) {
    across[x] = 0.125 * sphere_texel(map, image, x, y - 1) + 0.75 * sphere_texel(map, image, x, y) +
                0.125 * sphere_texel(map, image, x, y + 1);
  }
  for (int x = 1; x + 1 < w; ++x) means[x] = 0.125 * (across[x - 1] + across[x + 1]) + 0.75 * across[x];
  for (const int x : {0, w - 1}) means[x] = mean_over_texel(image, map, x, y);
  return means;
}

double cell_pdf(const EnvironmentTable& table, std::uint32_t x, std::uint32_t y) {
  const auto sums = row_sums(table, y);
  const double units = static_cast<double>(table.rows[y + 1] - table.rows[y]) * (sums[x + 1] - sums[x]);
  return units / kUnit / kUnit / texel_solid_angle(table.map, table.width, table.height, static_cast<int>(y));
}

}  // namespace

EnvironmentTable tabulate_environment(const Image& image, SphereMap map) {
  if (std::max(image.width, image.height) > kLongestSide)
    throw InputError("an environment map's sides must not be longer than 2^22 texels");
  EnvironmentTable table;
  table.map = map;
  table.width = image.width;
  table.height = image.height;
  const std::size_t w = image.width, h = image.height;
  table.columns.resize(h * (w + 1));
  table.column_guide.resize(h * (EnvironmentTable::guide_size(image.width) + 1));
  std::vector<double> rows(h);
  std::vector<glm::dvec3> integrals(h, glm::dvec3(0));
  parallel_for(h, [&](std::size_t y) {
    std::vector<double> weights(w);
    const std::vector<glm::dvec3> means = means_over_row(image, map, static_cast<int>(y));
    const double solid_angle = texel_solid_angle(map, image.width, image.height, static_cast<int>(y));
    for (std::size_t x = 0; x < w; ++x) {
      integrals[y] += means[x] * solid_angle;
      weights[x] = luminance(means[x]);
      rows[y] += weights[x] * solid_angle;
    }
    accumulate(weights, row_sums(table, y));
    guide(row_sums(std::as_const(table), y), row_guide(table, y));
  });
  for (const glm::dvec3& integral : integrals) table.integral += integral;
  if (std::all_of(rows.begin(), rows.end(), [](double row) { return row == 0; })) {
    for (std::size_t y = 0; y < h; ++y)
      rows[y] = texel_solid_angle(map, image.width, image.height, static_cast<int>(y));
  }
  table.rows.resize(h + 1);
  table.row_guide.resize(EnvironmentTable::guide_size(image.height) + 1);
  accumulate(rows, table.rows);
  guide(table.rows, table.row_guide);
  return table;
}

EnvironmentSample sample_environment(const EnvironmentTable& table, const glm::dvec2& point) {
  const Choice row = choose(table.rows, table.row_guide, point.y);
  const Choice column = choose(row_sums(table, row.cell), row_guide(table, row.cell), point.x);
  const double u = (column.cell + column.within) / table.width;
  EnvironmentSample sample;
  sample.pdf = cell_pdf(table, column.cell, row.cell);
  if (table.map == SphereMap::octahedral) {
    sample.direction = direction_of_square(table.map, {u, (row.cell + row.within) / table.height});
    return sample;
  }
  const double top = std::cos(kPi * row.cell / table.height),
               bottom = std::cos(kPi * (row.cell + 1) / table.height);
  const double z = top + row.within * (bottom - top), ring = std::sqrt(std::max(0.0, 1 - z * z));
  sample.direction = {ring * std::cos(2 * kPi * u), ring * std::sin(2 * kPi * u), z};
  return sample;
}

double environment_pdf(const EnvironmentTable& table, const glm::dvec3& direction) {
  const glm::dvec2 square = square_of_direction(table.map, direction);
  const int x = std::clamp(static_cast<int>(square.x * table.width), 0, table.width - 1);
  const int y = std::clamp(static_cast<int>(square.y * table.height), 0, table.height - 1);
  return cell_pdf(table, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
}

}  // namespace capcon
