#include "shading/virtual_light.h"

#include <cmath>

#include "shading/scene_bounds.h"
#include "shading/spectrum.h"

namespace capcon {

double default_geometry_limit(const Scene& scene) {
  const double distance = 0.04 * 2 * scene_bounds(scene).radius;
  return distance > 0 ? 1 / (distance * distance) : 1;
}

std::vector<std::uint32_t> power_thresholds(const std::vector<glm::dvec3>& powers) {
  double all = 0;
  for (const glm::dvec3& power : powers) all += luminance(power);
  std::vector<std::uint32_t> thresholds;
  double sum = 0;
  std::uint64_t before = 0;
  for (const glm::dvec3& power : powers) {
    sum += luminance(power);
    auto end = static_cast<std::uint64_t>(std::llround(all > 0 ? sum / all * 0x1p32 : 0));
    if (luminance(power) > 0 && end <= before) end = before + 1;
    before = std::min<std::uint64_t>(std::max(before, end), 0xffffffffu);
    thresholds.push_back(static_cast<std::uint32_t>(before));
  }
  if (!thresholds.empty()) thresholds.back() = 0xffffffffu;
  return thresholds;
}

}  // namespace capcon
