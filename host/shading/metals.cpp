#include "shading/metals.h"

namespace capcon {
namespace {

struct GlassIndex {
  const char* name;
  double eta;
};

constexpr GlassIndex kGlasses[] = {
    {"glass-BK7", 1.5168}, {"glass-BAF10", 1.6700}, {"glass-FK51A", 1.4866}, {"glass-LASF9", 1.8502},
    {"glass-F5", 1.6727},  {"glass-F10", 1.7283},   {"glass-F11", 1.7847},  // SF5, SF10, SF11 in pbrt-v4
};

}  // namespace

const std::vector<MetalIndex>& named_metals() {
  static const std::vector<MetalIndex> kMetals = {
      {"Ag", {0.155, 0.117, 0.138}, {4.828, 3.122, 2.147}},
      {"Al", {1.657, 0.880, 0.521}, {9.224, 6.270, 4.837}},
      {"Au", {0.143, 0.375, 1.442}, {3.983, 2.386, 1.603}},
      {"Cr", {4.370, 2.917, 1.655}, {5.206, 4.231, 3.755}},
      {"Cu", {0.200, 0.924, 1.102}, {3.913, 2.453, 2.142}},
      {"CuO", {3.245, 2.450, 2.197}, {0.520, 0.571, 0.717}},
      {"CuZn", {0.444, 0.527, 1.094}, {3.695, 2.765, 1.829}},
      {"Hg", {2.399, 1.440, 0.910}, {6.328, 4.372, 3.422}},
      {"MgO", {2.090, 1.651, 1.595}, {0, 0, 0}},
      {"TiO2", {3.457, 2.802, 2.905}, {0, 0, 0.001}},
  };
  return kMetals;
}

std::optional<glm::dvec3> named_metal_spectrum(const std::string& name) {
  for (const MetalIndex& metal : named_metals()) {
    const std::string metal_name = metal.name;
    for (const bool is_eta : {true, false}) {
      const std::string part = is_eta ? "eta" : "k";
      const std::string file = metal_name + '.' + part + ".spd";
      const bool as_file = name == file || name.ends_with('/' + file);
      if (as_file || name == "metal-" + metal_name + '-' + part) return is_eta ? metal.eta : metal.k;
    }
  }
  return std::nullopt;
}

std::optional<double> named_glass_index(const std::string& name) {
  for (const GlassIndex& glass : kGlasses) {
    if (name == glass.name) return glass.eta;
  }
  return std::nullopt;
}

}  // namespace capcon
