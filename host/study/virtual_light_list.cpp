#include "study/virtual_light_list.h"

#include <fmt/format.h>

#include <functional>
#include <iterator>

namespace capcon {
namespace {

void for_each(const VirtualLights& lights,
              const std::function<void(std::uint32_t set, const VirtualLight& light)>& visit) {
  for (std::uint32_t set = 0; set < lights.sets(); ++set) {
    for (std::uint32_t k = lights.first[set]; k < lights.first[set + 1]; ++k) visit(set, lights.lights[k]);
  }
}

}  // namespace

std::string virtual_lights_csv(const VirtualLights& lights) {
  std::string text = "set,path,bounce,x,y,z,nx,ny,nz,flux_r,flux_g,flux_b\n";
  for_each(lights, [&](std::uint32_t set, const VirtualLight& l) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{},{}\n", set, l.path, l.bounce,
                   l.position.x, l.position.y, l.position.z, l.normal.x, l.normal.y, l.normal.z, l.flux.x,
                   l.flux.y, l.flux.z);
  });
  return text;
}

std::string virtual_lights_json(const VirtualLights& lights) {
  std::string text = "[";
  for_each(lights, [&](std::uint32_t set, const VirtualLight& l) {
    fmt::format_to(
        std::back_inserter(text),
        "{}\n{{\"set\": {}, \"path\": {}, \"bounce\": {}, \"position\": [{}, {}, {}], \"normal\": [{}, "
        "{}, {}], \"flux\": [{}, {}, {}]}}",
        text.size() == 1 ? "" : ",", set, l.path, l.bounce, l.position.x, l.position.y, l.position.z,
        l.normal.x, l.normal.y, l.normal.z, l.flux.x, l.flux.y, l.flux.z);
  });
  return text + "\n]\n";
}

}  // namespace capcon
