#pragma once

#include "plot/canvas.h"
#include "points/measure.h"
#include "points/spectrum.h"

namespace capcon::plot {

/// The points in their Voronoi cells, coloured by n area from 1/2 to 3/2; the torus' images complete the
/// border. More than kCropAbove points: the lower left part with about a thousand. Returns the part's side, 1
/// = all.
double draw_cells(Canvas& canvas, const Box& box, const Points& points);

/// The spectrum in 33 greys of sqrt(P / 4): white noise is middle grey, P >= 4 white. P(0) is left out
/// (black).
void draw_spectrum(Canvas& canvas, const Box& box, const Spectrum& spectrum);

/// Names to the left, values to the right, 15 a row.
void draw_figures(Canvas& canvas, const Box& box, const Measures& measures, const RadialSpectrum* radial);

/// What the colours of the cells, the greys of the spectra and the dashed lines mean: side by side (720 x
/// 24), or stacked (240 x 80).
void draw_legend(Canvas& canvas, glm::dvec2 at, bool stacked);

}  // namespace capcon::plot
