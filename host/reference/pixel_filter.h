#pragma once

namespace capcon::reference {

/// Where the distribution of density proportional to exp(-2 t^2) - exp(-4.5) on [-1.5, 1.5] reaches u in [0,
/// 1]: pbrt-v4's Gaussian filter along one axis, in pixels from the centre.
double gaussian_quantile(double u);

}  // namespace capcon::reference
