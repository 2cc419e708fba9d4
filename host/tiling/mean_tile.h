#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "tiling/tied_points.h"

namespace capcon {

/// How uneven the mean tile is: the sum over frequencies 0 < |(m, n)| <= reach of |F|^2, F = sum over the
/// free points of copies_per_tile * exp(-2 pi i (m, n) . position). It is what repeats in every tile of a
/// random tiling: the bias of an unrotated tiling, and the spikes at the tile frequency in the spectrum (of
/// height tiles / nt |F|^2). `low_first` weights each with reach^2 / |(m, n)|^2: what surrounds low
/// frequencies in a spectrum is small. `gradient` (optional) receives the derivative by every free point's
/// position.
double mean_tile_unevenness(const TiedPoints& points, double reach,
                            std::vector<glm::dvec2>* gradient = nullptr, bool low_first = false);

/// max |F|^2 over the same frequencies.
double mean_tile_peak(const TiedPoints& points, double reach);

}  // namespace capcon
