#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "scene/scene.h"

namespace capcon {

/// What a colour is for: it decides how a spectrum becomes RGB, see spectrum.h.
enum class ColourUse { reflectance, emission };

/// The entry, nullptr when absent.
const Parameters::Entry* find_entry(const Parameters& parameters, const std::string& name);

/// A colour in linear sRGB, not below 0: rgb and color as they are, xyz by its matrix, one float as a grey,
/// "spectrum" as wavelength-value pairs or by name (a metal, a glass, a standard illuminant, or a text file
/// of pairs beside the scene), "blackbody" as [kelvin] (pbrt-v4: Y = 1) or as [kelvin scale] (pbrt-v2 and v3:
/// the spectrum's peak is `scale`). Nothing when it is absent or names a texture; InputError with its place
/// for malformed values.
std::optional<glm::dvec3> read_colour(const Parameters& parameters, const std::string& name, ColourUse use);

/// The same, with a value for when it is absent.
glm::dvec3 read_colour(const Parameters& parameters, const std::string& name, ColourUse use,
                       const glm::dvec3& fallback);

/// A number from `least` to 1e30. InputError with its place otherwise.
double read_number(const Parameters& parameters, const std::string& name, double fallback, double least);

}  // namespace capcon
