#pragma once

#include <functional>
#include <string>

#include "plot/canvas.h"

namespace capcon::plot {

/// An SVG or PNG document with what `draw` paints, by the path's extension (see check_picture_name); written
/// completely or not at all. A PNG has `scale` pixels a unit.
void write_picture(const std::string& path, double width, double height,
                   const std::function<void(Canvas&)>& draw, double scale = 1.5);

/// InputError unless the name ends in .svg or .png; Failure if it could not be written.
void check_picture_name(const std::string& path);

}  // namespace capcon::plot
