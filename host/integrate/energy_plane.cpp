#include "integrate/energy_plane.h"

#include "integrate/estimator.h"

namespace capcon::integrate {

std::vector<GeneratorEnergy> energy_plane(std::uint32_t n, std::uint64_t seed) {
  std::vector<GeneratorEnergy> plane;
  for (const Estimator& estimator : estimators()) {
    if (estimator.weights != Weights::equal) continue;
    const auto source = make_source(estimator.method, n, seed);
    GeneratorEnergy entry{estimator.method, base_sets(n), 0, 0};
    for (std::uint32_t t = 0; t < entry.sets; ++t) {  // one of each base set; a shift changes neither figure
      const Measures measures = measure(source->set(t));
      entry.energy += measures.energy / entry.sets;
      entry.area_sd += measures.area_sd / entry.sets;
    }
    plane.push_back(entry);
  }
  return plane;
}

}  // namespace capcon::integrate
