#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "integrate/cell_sums.h"
#include "points/point_set.h"

namespace capcon::integrate {

enum class Weights : std::uint8_t {
  equal,  ///< 1/n
  areas,  ///< of the Voronoi cells, in the integrand's own domain: on the torus where it is periodic, else in
          ///< the square
  importance  ///< 1 / (n density), at places drawn from that density
};

/// A way of the text to choose places and weights.
struct Estimator {
  std::string name;    ///< the points' method, with "-areas" behind it; "importance"
  std::string method;  ///< of the points
  Weights weights = Weights::equal;
};

/// random, importance, random-areas, every other method of generator_names(), capcon, pmj02, and for each of
/// ccvt, fpo and lloyd that there is, the same points with areas as weights.
const std::vector<Estimator>& estimators();
/// Also one of `point_files`, files of points as samplers by their labels ("mine": "file:mine.txt"), whose
/// method is the sampler. InputError with the names there are.
Estimator find_estimator(std::string_view name, const std::map<std::string, std::string>& point_files = {});

/// Randomised sets of n points of one method.
class PointSource {
 public:
  virtual ~PointSource() = default;
  /// Set number `trial`: the same for the same arguments, from any thread.
  virtual Points set(std::uint64_t trial) const = 0;
  /// That set's cells on the torus.
  virtual TorusCells cells(const Points& set, std::uint64_t /*trial*/) const { return torus_cells(set); }
  /// Processor seconds it took to make what all sets share, for one base set; 0 where nothing is shared.
  double preparation_seconds = 0;
};

/// random, jittered and Sobol' points under their own scrambling are made anew for each trial; capcon's
/// tilings too, with a rotation as in the renderer, and pmj02's choice of a sequence and its digit
/// scrambling, and the sets of a file. All others are base sets, made once, that each trial shifts on the
/// torus: trial t takes base set t mod base_sets(n).
std::unique_ptr<PointSource> make_source(const std::string& method, std::uint32_t n, std::uint64_t seed);

/// How many different base sets stand behind the trials at n points: 8, fewer above 256 points, at least 2.
std::uint32_t base_sets(std::uint32_t n);

/// How the method's sets differ, in words.
std::string randomisation_of(const std::string& method);

/// Processor seconds of this process, all threads.
double cpu_seconds();

}  // namespace capcon::integrate
