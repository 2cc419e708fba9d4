#include "points/halved_order.h"

#include <algorithm>
#include <utility>

namespace capcon {
namespace {

void halve(std::uint32_t* first, std::uint32_t* last, std::uint32_t columns, std::uint32_t level,
           std::uint32_t levels) {
  if (level == levels || last - first < 2) return;
  std::uint32_t* const middle = first + (last - first) / 2;
  const auto key = [&](std::uint32_t c) {
    const std::uint32_t x = c % columns, y = c / columns;
    return level % 2 == 0 ? std::pair(x, y) : std::pair(y, x);
  };
  std::nth_element(first, middle, last, [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  halve(first, middle, columns, level + 1, levels);
  halve(middle, last, columns, level + 1, levels);
}

}  // namespace

void halve_in_turn(std::uint32_t* cells, std::uint32_t count, std::uint32_t columns, std::uint32_t levels) {
  halve(cells, cells + count, columns, 0, levels);
}

}  // namespace capcon
