#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace capcon {

/// A spectrum by its samples: wavelengths in nm that rise strictly, and values. Between samples it is linear,
/// beyond the first and the last it is constant, as in pbrt.
struct Spectrum {
  std::vector<double> wavelengths;
  std::vector<double> values;

  double at(double wavelength) const;
};

/// The CIE 1931 colour matching functions (x, y, z) at a wavelength in nm, by the multi-lobe fit of Wyman,
/// Sloan and Shirley, "Simple Analytic Approximations to the CIE XYZ Color Matching Functions", JCGT 2(2),
/// 2013. Largest error 0.02 or so of a peak near 1.8.
glm::dvec3 colour_matching(double wavelength);

/// XYZ to linear sRGB (IEC 61966-2-1).
glm::dvec3 rgb_of_xyz(const glm::dvec3& xyz);

/// Luminance Y of linear sRGB.
double luminance(const glm::dvec3& rgb);

/// What a light of this spectrum looks like: XYZ = integral of value x matching function over 380 to 780 nm,
/// divided by that of y alone, as linear sRGB without what is negative. The constant spectrum 1 has Y = 1 and
/// is a little pinker than white: it is equal-energy light and not D65.
glm::dvec3 rgb_of_emission(const Spectrum& spectrum);

/// A reflectance, or eta and k of a metal: the same, divided by the sRGB of the constant spectrum 1. So a
/// constant spectrum stays what it is, and a white wall is white under white light. (pbrt-v2 and v3 leave
/// that division out: their values are these times rgb_of_emission of 1, about 1.20, 0.95, 0.91.)
glm::dvec3 rgb_of_reflectance(const Spectrum& spectrum);

/// The weights of rgb_of_reflectance for values at these wavelengths: the sum of value x weight is the
/// colour, up to its negative part. For many spectra over the same wavelengths.
std::vector<glm::dvec3> reflectance_weights(const std::vector<double>& wavelengths);

/// Planck's law at `kelvin` > 0, divided by its peak (Wien's law): 1 at the peak.
double blackbody(double wavelength, double kelvin);
/// Linear sRGB of a black body whose spectrum peaks at 1, as pbrt-v3 has it.
glm::dvec3 rgb_of_blackbody(double kelvin);

/// Linear sRGB with Y = 1 of a standard illuminant named as in pbrt-v4 ("stdillum-D65", "stdillum-A");
/// nothing for a name that is not known. D of any number by the daylight locus of CIE 15:2004, section 3.1.
std::optional<glm::dvec3> rgb_of_illuminant(const std::string& name);

}  // namespace capcon
