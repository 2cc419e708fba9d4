#pragma once

#include "generator/mesh.h"

namespace capcon::scenes {

/// A round table on three curved feet, 0.74 high, radius 0.48. Materials timber, iron.
Model round_table();

/// A ladder-back chair with a woven seat; stands on z = 0 round the origin and looks to +y. Materials timber,
/// straw.
Model ladder_chair();

/// A carafe, glasses and plates for a round table top at z = 0. Materials glass, china.
Model table_ware();

/// A wrought-iron lantern on a chain; hangs from the origin, 1.1 long. Materials iron, china.
Model lantern();

/// A bench of stone on two consoles along x, 1.5 long, its back at y = 0. Material stone.
Model stone_bench();

}  // namespace capcon::scenes
