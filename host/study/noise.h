#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/statistics.h"
#include "study/run_images.h"
#include "study/runner.h"

namespace capcon {

/// What of an error is noise, new with every seed, and what is structure, for one sampler at one count.
/// Errors are root mean squares over pixels and channels.
struct NoiseCell {
  std::string sampler;
  std::uint32_t samples = 0;
  Interval deviation;     ///< of the pixels' standard deviations over seeds
  double mean_error = 0;  ///< of (mean image over seeds - reference)
  double chance = 0;  ///< what mean_error is without bias: sqrt(deviation^2 / seeds + the reference's error)
  Interval bias_square;  ///< mean_error^2 - chance^2: of a bias its mean square, else about 0
  Interval coarse;       ///< share of the squared error that is left by a box filter of kCoarseBlock pixels
  std::vector<double> coarse_mse;  ///< of each seed, less that of the reference
};

/// Where in the picture noise and mean error lie; grey, root mean squares over channels.
struct NoiseMap {
  std::string sampler;
  Image deviation, mean_error;
};

struct Noise {
  std::vector<NoiseCell> cells;  ///< by rising counts, in each by samplers
  std::vector<NoiseMap> maps;
  std::uint32_t map_samples = 0;
  std::uint32_t seeds = 0;
  double coarse_by_chance = 0;  ///< the share that independent pixels would have: blocks / pixels

  const NoiseCell* cell(const std::string& sampler, std::uint32_t samples) const;
};

/// The figures of one cell from its images, one a seed (two at least, else most are NaN). Intervals are 95 %,
/// by the jackknife over seeds; sampler and samples are left to the caller.
NoiseCell noise_of(const std::vector<Image>& images, const ReferenceImage& reference);
NoiseMap noise_map(const std::vector<Image>& images, const Image& reference);

/// Coarse MSE of `a` beside that of `b`: ratio of geometric means with its interval. NaN where one is not
/// positive.
Interval coarse_ratio(const NoiseCell& a, const NoiseCell& b);

/// Of all cells, and maps of the samplers that are looked at most: sobol-xor, capcon and capcon-domain at 4
/// (else the middle count). Runs without an image (they were measured, so there is none only where somebody
/// removed it meanwhile) are left out.
Noise make_noise(const StudyResult& result, const RunImages& images);

}  // namespace capcon
