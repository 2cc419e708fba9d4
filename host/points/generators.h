#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "points/point_set.h"

namespace capcon {

/// Names that `generate` knows: random jittered sobol sobol-xor sobol-owen halton ccvt.
const std::vector<std::string>& generator_names();

struct GeneratorOptions {
  std::uint32_t n = 1024;
  std::uint64_t seed = 1;
  std::uint32_t capacity = 1024;  ///< ccvt only
};

/// n points of the named method. InputError for an unknown name (with the names there are) or n = 0.
Points generate(std::string_view method, const GeneratorOptions& options);

}  // namespace capcon
