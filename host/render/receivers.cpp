#include "render/receivers.h"

#include <bit>

namespace capcon {
namespace {

constexpr std::size_t kTexels = 6;  // a ray

}  // namespace

Receivers pick_receivers(std::span<const glm::uvec4> found, std::uint32_t places,
                         const std::function<std::uint32_t(std::uint32_t)>& place, const Receivers* before) {
  std::vector<std::vector<std::uint32_t>> rays(places);
  for (std::size_t ray = 0; ray < found.size() / kTexels; ++ray) {
    const glm::uvec4* t = &found[kTexels * ray];
    if (t[1].w != 0) rays[place(t[2].w)].push_back(static_cast<std::uint32_t>(ray));
  }
  Receivers receivers;
  for (const auto& of_place : rays) {
    for (const std::uint32_t ray : of_place) {
      const glm::uvec4* t = &found[kTexels * ray];
      receivers.surfaces.insert(receivers.surfaces.end(), t, t + 3);
      receivers.shading.insert(receivers.shading.end(), t + 3, t + 5);
      glm::dvec3 scale(std::bit_cast<float>(t[5].x), std::bit_cast<float>(t[5].y),
                       std::bit_cast<float>(t[5].z));
      if (before) scale *= before->weights[t[5].w].scale;
      receivers.weights.push_back({scale, t[2].w});
    }
    receivers.first.push_back(receivers.count());
  }
  return receivers;
}

}  // namespace capcon
