#pragma once

#include "plot/canvas.h"

namespace capcon::plot {

// Grounds, inks and lines of the sheets, as in the study's report.
inline constexpr Colour kGround{253, 253, 251}, kInk{28, 31, 35}, kSoft{93, 100, 109}, kRule{217, 219, 214},
    kFaint{238, 239, 235}, kPanel{245, 245, 241}, kBlue{0, 96, 168}, kRed{207, 51, 16};

/// -1 dark blue, 0 nearly white, 1 dark orange, beyond it the ends: tells high from low without red and
/// green.
Colour diverging(double t);

/// 0 black to 1 white, equal steps of lightness.
Colour grey(double t);

}  // namespace capcon::plot
