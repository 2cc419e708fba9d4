#include "study/integral.h"

#include <array>

namespace capcon {

const IntegralWords& words_of(Integral integral) {
  static constexpr std::array<IntegralWords, 4> kWords = {{
      {"ambient-occlusion", "Ambient occlusion", "samples a pixel", "sample", "samples",
       "A(x, n, r) = (1/π) ∫ V(x, ω, r) |cos θ| dω over the hemisphere of n; V is 0 where a surface lies "
       "within r along ω, else 1. "
       "Directions are cosine-weighted through the concentric map, so a pixel's estimate is the mean of V.",
       "The scene's ambient occlusion, converged"},
      {"direct", "Direct lighting", "integrator samples a pixel", "sample", "samples",
       "L(x, ω) = L_e + ∫ f(x, ω, ω') L_d(x, ω') |cos θ'| dω', L_d the light straight from the lights. n "
       "points on each light and n "
       "of the BSDF, combined by multiple importance sampling with the power heuristic; each set is one set "
       "of the sampler.",
       "The scene in direct light, converged"},
      {"splitting", "Trajectory splitting", "image samples a pixel", "sample", "samples",
       "L(x, ω) = L_e + ∫ f(x, ω, ω') L_d(x, ω') |cos θ'| dω' as in the study of direct lighting. Of N "
       "points a pixel for each light and "
       "for the BSDF, each of P image samples has N/P. They are the parts of one set of N, or (naive) P sets "
       "of their own.",
       "The scene in direct light, converged"},
      {"igi", "Instant global illumination", "sets of light paths", "set", "sets",
       "Light that comes to x by at least one other surface: Σ f(x, ω, ω') min(b, G) V f(y, …) Φ over the "
       "virtual "
       "point lights y of all sets, divided by their number, and what the limit b leaves out by rays of its "
       "own "
       "(docs/igi.md). What the samplers differ in is where the N light paths of each of S sets start and "
       "go: the "
       "sets are the parts of one set of N S points, or (naive) sets of their own. Light straight from the "
       "lights "
       "is left out: it is another study's, and would add the same noise to all.",
       "The scene in indirect light, converged"},
  }};
  return kWords[static_cast<std::size_t>(integral)];
}

Variant parse_variant(const std::string& name) {
  for (const auto& [suffix, factor] :
       {std::pair<std::string_view, std::uint32_t>{"-naive2", 2}, {"-naive", 1}}) {
    if (name.ends_with(suffix)) return {name.substr(0, name.size() - suffix.size()), false, factor};
  }
  return {name, true, 1};
}

}  // namespace capcon
