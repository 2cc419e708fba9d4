#pragma once

#include "generator/mesh.h"

namespace capcon::scenes {

/// Terracotta pots on z = 0 with earth in them; plants stand at `soil`. Materials pot, earth.
struct Pot {
  Model model;
  double soil;
};
Pot flower_pot(double height);        ///< a cone with a rim
Pot urn(double height);               ///< a bellied jar on a foot
Pot tub(double size, double height);  ///< a square planter with panels; material stone

}  // namespace capcon::scenes
