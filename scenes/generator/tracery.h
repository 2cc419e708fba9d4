#pragma once

#include "generator/wall.h"

namespace capcon::scenes {

/// Stone bars and glass for a pointed opening in a wall at y = 0: two lancets under a ring, at depth `recess`
/// behind the face. Materials stone, glass.
Model two_lights(const Opening& opening, double recess);

/// One pointed light with iron cross bars. Materials iron, glass.
Model lancet(const Opening& opening, double recess);

/// A splayed moulding round a pointed opening, on the wall's face. Material stone.
Mesh hood(const Opening& opening);

}  // namespace capcon::scenes
