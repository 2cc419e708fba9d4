#pragma once

#include <string>

#if !defined(CAPCON_DATA_DIR) && __has_include("capcon/data_dir.h")
#include "capcon/data_dir.h"  // written by the installation
#endif

namespace capcon::sampling {

/// A point of the unit square, [0, 1) along each side: a multiple of 2^-32. The renderer's floats are its
/// upper 24 bits.
struct Point {
  double x = 0;
  double y = 0;
};

/// Where the shipped tiles and ensembles lie: as find_package(capcon) found them, else where they were
/// installed; the environment variable CAPCON_DATA goes before both.
inline std::string shipped_data() {
#ifdef CAPCON_DATA_DIR
  return CAPCON_DATA_DIR;
#else
  return {};
#endif
}

}  // namespace capcon::sampling
