#pragma once

#include <cstdint>

namespace capcon {

/// Orders cells (column + columns * row) by halving them along x, y, x, ... in turn: the half with the lower
/// columns (rows) comes first, and so on, `levels` deep. Aligned blocks of count / 2^k cells that follow each
/// other are then compact regions with just as many cells each, as the strata of a net are; blocks of a
/// Morton curve are not, as a set has a cell more here and one less there, so that its blocks lie across
/// the curve's jumps. With 32 levels the order is that of the set alone, whatever the order before.
void halve_in_turn(std::uint32_t* cells, std::uint32_t count, std::uint32_t columns,
                   std::uint32_t levels = 32);

}  // namespace capcon
