#pragma once

#include "generator/wall.h"

namespace capcon::scenes {

/// What fills an opening round x = 0 of a wall at y = 0 that faces -y: frame, leaves, sill. Material stone
/// and those named.
Model door(const Opening& opening);                   ///< timber
Model window(const Opening& opening, bool shutters);  ///< timber, glass, shutter

}  // namespace capcon::scenes
