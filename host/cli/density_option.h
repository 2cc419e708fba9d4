#pragma once

#include <memory>
#include <string>

#include "points/density.h"

namespace capcon::cli {

/// What --density says: the luminance of an image (a name that ends in .exr or .png; row 0 is at y = 0) or a
/// formula in x and y at the midpoints of 1024 x 1024 texels. InputError with the file, pixel, column or
/// place that is wrong.
std::shared_ptr<const Density> read_density(const std::string& text);

}  // namespace capcon::cli
