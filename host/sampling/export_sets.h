#pragma once

#include <string>

#include "points/ensemble.h"

namespace capcon {

// An ensemble's sets for programs that are not ours (docs/domain-sets.md says how they are used): cell
// `index` of set `set` has its low corner at (column / columns, row / rows) of the unit square.

/// A C header, C99 and C++: sizes as macros, the cells as a table of bytes pairs, and a function that makes a
/// point of a set, a symmetry and two random numbers. Every name begins with capcon_DOMAIN_POINTS.
std::string as_c_header(const Ensemble& ensemble, EnsembleDomain domain);

/// The same as an include for GLSL (version 450 on), cells two to a uint.
std::string as_glsl(const Ensemble& ensemble, EnsembleDomain domain);

/// A NumPy array (.npy) of float64, shape (sets, points, 4): x and y of a cell's low corner, its width and
/// height.
std::string as_numpy(const Ensemble& ensemble);

}  // namespace capcon
