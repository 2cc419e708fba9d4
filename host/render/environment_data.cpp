#include <cmath>
#include <span>

#include "base/parallel.h"
#include "render/light_data.h"
#include "render/texels.h"

namespace capcon {
namespace {

constexpr double kPi = 3.14159265358979323846;

std::uint32_t append_words(std::span<const std::uint32_t> words, std::vector<glm::uvec4>& texels) {
  const auto place = static_cast<std::uint32_t>(texels.size());
  for (std::size_t i = 0; i < words.size(); i += 4) {
    glm::uvec4 t(0);
    for (std::size_t k = 0; k < 4 && i + k < words.size(); ++k) t[static_cast<int>(k)] = words[i + k];
    texels.push_back(t);
  }
  return place;
}

/// 1 - |z| at the upper edge of row y, by the pole of the row's own half: near a pole 1 - cos would lose
/// digits.
double depth(int edge, int row, int height) {
  const double from_top = std::sin(kPi * edge / (2.0 * height)),
               from_below = std::cos(kPi * edge / (2.0 * height));
  return 2 * row < height ? 2 * from_top * from_top : 2 * from_below * from_below;
}

}  // namespace

std::uint32_t append_map(const Image& image, const EnvironmentTable& table, std::vector<glm::uvec4>& texels) {
  const auto base = static_cast<std::uint32_t>(texels.size());
  texels.resize(texels.size() + 2);
  const auto rows = static_cast<std::uint32_t>(texels.size());
  for (int y = 0; y <= table.height; ++y) {
    const bool last = y == table.height;
    const double share =
        last ? 0 : static_cast<double>(table.rows[y + 1] - table.rows[y]) / EnvironmentTable::kUnit;
    const double solid_angle = texel_solid_angle(table.map, table.width, table.height, last ? 0 : y);
    texels.push_back({table.rows[y], float_bits(depth(y, y, table.height)),
                      float_bits(share / solid_angle / EnvironmentTable::kUnit),
                      float_bits(depth(y + 1, y, table.height))});
  }
  const std::uint32_t row_guide = append_words(table.row_guide, texels);
  const std::uint32_t columns = append_words(table.columns, texels);
  const std::uint32_t column_guide = append_words(table.column_guide, texels);
  const auto pixels = static_cast<std::uint32_t>(texels.size());
  texels.resize(texels.size() + std::size_t(image.width) * image.height);
  parallel_for(image.height, [&](std::size_t y) {
    glm::uvec4* row = &texels[pixels + y * image.width];
    for (int x = 0; x < image.width; ++x)
      row[x] = make_texel(sphere_texel(table.map, image, x, static_cast<int>(y)), 0u);
  });
  texels[base] = {rows, row_guide, columns, column_guide};
  texels[base + 1] = {pixels, table.width, table.height, table.map == SphereMap::octahedral ? 1 : 0};
  return base;
}

}  // namespace capcon
