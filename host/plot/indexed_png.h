#pragma once

#include <string>

#include "plot/canvas.h"

namespace capcon::plot {

/// A PNG of at most 256 colours (colour type 3), a third of the size of a full one. Exact where the picture
/// has no more; else similar colours are merged, and the rarest take the nearest of the 256 commonest.
/// Failure if it would exceed 2 GB.
std::string encode_png(const Pixels& pixels);

}  // namespace capcon::plot
