#pragma once

namespace capcon {

/// Below this a GGX lobe is as good as a mirror; smaller alphas are raised to it, so that densities stay
/// finite.
inline constexpr double kSmallestAlpha = 1e-3;

/// GGX alpha of a pbrt-v2 "roughness" r: its Blinn exponent is 1/r, and a Blinn lobe of exponent e is as wide
/// as a microfacet distribution of alpha = sqrt(2 / (e + 2)) (Walter et al., EGSR 2007, section 5.2).
double alpha_of_v2(double roughness);

/// pbrt-v3 with "remaproughness" (the default): the polynomial in ln r of Pharr, Jakob and Humphreys 2016,
/// section 8.4.2. Without it alpha is the roughness itself. It differs from alpha_of_v2 by less than 0.06 for
/// r up to 0.1.
double alpha_of_v3(double roughness);

/// pbrt-v4 with "remaproughness" (the default): sqrt(r) (Pharr, Jakob and Humphreys 2023, section 9.6).
double alpha_of_v4(double roughness);

}  // namespace capcon
