// Measured BRDFs and spectra.
#include <cmath>

#include "fuzz/files.h"
#include "fuzz/target.h"
#include "shading/colours.h"
#include "shading/measured_brdf.h"

namespace capcon::fuzz {

void read_cornell(std::string_view bytes) {
  const CornellBrdf brdf = parse_cornell_brdf(bytes, "f.brdf");
  require(!brdf.samples.empty(), "a table has rows");
  for (const BrdfSample& sample : brdf.samples) {
    for (const double angle : {sample.theta_in, sample.phi_in, sample.theta_out, sample.phi_out})
      require(std::isfinite(angle), "angles are finite");
    for (int c = 0; c < 3; ++c)
      require(std::isfinite(sample.value[c]) && sample.value[c] >= 0, "values are finite, 0 or more");
  }
}

void read_merl(std::string_view bytes) {
  const MerlBrdf brdf = parse_merl_brdf(bytes, "f.binary");
  require(brdf.values.size() == static_cast<std::size_t>(brdf.size[0]) * brdf.size[1] * brdf.size[2],
          "a table has the size that it says");
  for (const glm::vec3& value : brdf.values)
    for (int c = 0; c < 3; ++c)
      require(std::isfinite(value[c]) && (value[c] >= 0 || value == glm::vec3(-1)),
              "values are finite, 0 or more where they were measured");
}

void read_spectrum(std::string_view bytes) {
  const MemoryFile file(bytes);
  Parameters parameters;
  parameters.entries["c"] = {
      "spectrum", std::vector<std::string>{file.path().string()}, {"scene.pbrt", 1, 1}};
  for (const ColourUse use : {ColourUse::reflectance, ColourUse::emission}) {
    const auto colour = read_colour(parameters, "c", use);
    require(colour.has_value(), "a spectrum that is there is read");
    for (int c = 0; c < 3; ++c)
      require((*colour)[c] >= 0 && std::isfinite((*colour)[c]), "a colour is finite, 0 or more");
  }
}

}  // namespace capcon::fuzz
