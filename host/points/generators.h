#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "points/fpo.h"
#include "points/lattice_points.h"
#include "points/point_set.h"
#include "points/region.h"

namespace capcon {

/// Names that `generate` knows, in the order of the list below.
const std::vector<std::string>& generator_names();

struct GeneratorOptions {
  std::uint32_t n = 1024;
  std::uint64_t seed = 1;
  std::uint32_t capacity = 1024;                                  ///< ccvt only
  std::function<void(double fraction)> on_progress = {};          ///< how much seems done, may be empty
  FpoOptions::Strategy strategy = FpoOptions::Strategy::kGlobal;  ///< fpo only
  std::uint32_t rounds = 300;                                     ///< lloyd only
  LatticeKind kind = LatticeKind::kMaximin;                       ///< lattice only
  bool shift = false;               ///< lattice only: moved by a random vector, which the seed gives
  bool finish = false;              ///< ccvt only, on the plain torus: power cells of equal area
  std::function<bool()> stop = {};  ///< ccvt only: whether to end now, with what there is
  Region region = {};               ///< ccvt, lloyd, random and jittered only
};

/// n points of the named method. InputError for an unknown name (with the names there are) or n = 0, and
/// for a region other than the plain torus where the method has none.
/// - random: independent, uniform
/// - jittered: one point in each of n strata of equal area, rows of nearly square cells (rows may differ by
/// one)
/// - sobol: the first n points of the (0,2)-sequence, unscrambled: the seed changes nothing
/// - sobol-xor: the same with one random digit (XOR) scrambling a dimension
/// - sobol-owen: the same with Owen's nested uniform scrambling, each dimension on its own
/// - halton: radical inverses in bases 2 and 3: the seed changes nothing
/// - halton-scrambled: the same with Owen's nested uniform scrambling, see halton.h
/// - lattice: rank-1 or golden-ratio lattice, see lattice_points.h: the seed changes nothing but a shift
/// - lloyd: centroids of Voronoi cells, again and again: see lloyd.h
/// - fpo: farthest-point optimisation, see fpo.h
/// - ccvt: capacity-constrained, by swaps: see ccvt.h
Points generate(std::string_view method, const GeneratorOptions& options);

}  // namespace capcon
