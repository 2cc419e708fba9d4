#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace capcon {

/// The complex index of refraction eta + i k of a metal (or another solid) for linear sRGB.
struct MetalIndex {
  const char* name;
  glm::dvec3 eta;
  glm::dvec3 k;
};

/// The metals known by name. Values to three digits, as reduced to linear sRGB in the open tables that many
/// renderers share (Tungsten's, Yocto's), measured by SOPRA and others; CuZn after Mitsuba's documentation.
const std::vector<MetalIndex>& named_metals();

/// A spectrum's name in a scene file: pbrt-v4's "metal-Cu-eta", pbrt-v2's and v3's file "spds/Cu.eta.spd" or
/// "spds/Cu.k.spd". Nothing when it is none of these, or of a metal that is not known.
std::optional<glm::dvec3> named_metal_spectrum(const std::string& name);

/// The index of refraction of pbrt-v4's named glasses ("glass-BK7") at 589 nm, from their makers' catalogues.
std::optional<double> named_glass_index(const std::string& name);

}  // namespace capcon
