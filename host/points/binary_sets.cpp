#include "points/binary_sets.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>

#include "base/error.h"

namespace capcon {

namespace {

static_assert(std::endian::native == std::endian::little, "the file is read as it lies in memory");

template <class Number>
std::vector<Points> read_sets(std::string_view data, std::uint64_t sets, std::uint64_t count,
                              const std::string& name) {
  std::vector<Points> result(sets, Points(count));
  const char* at = data.data();
  for (std::uint64_t s = 0; s < sets; ++s) {
    for (std::uint64_t i = 0; i < count; ++i) {
      std::array<Number, 2> p;
      std::memcpy(p.data(), at, sizeof p);
      at += sizeof p;
      for (int axis = 0; axis < 2; ++axis) {
        const auto value = static_cast<double>(p[axis]);
        if (!(value >= 0 && value <= 1)) {
          throw InputError(
              {name, 0, 0},
              fmt::format("set {}, point {}: {} is not in [0, 1]; points live in the unit square", s + 1,
                          i + 1, value));
        }
        result[s][i][axis] = value == 1 ? 0.0 : value + 0.0;
      }
    }
  }
  return result;
}

}  // namespace

std::vector<Points> binary_sets(std::string_view data, bool doubles, std::uint64_t sets, std::uint64_t count,
                                const std::string& name) {
  if (sets == 0 || count == 0) throw InputError({name, 0, 0}, "holds no points");
  const std::uint64_t one = doubles ? 16 : 8, most = data.size() / one;
  if (sets > most || count > most / sets || sets * count * one != data.size()) {
    throw InputError({name, 0, 0},
                     fmt::format("has {} bytes behind its header, not {} sets of {} points of {} bytes",
                                 data.size(), sets, count, one));
  }
  return doubles ? read_sets<double>(data, sets, count, name) : read_sets<float>(data, sets, count, name);
}

}  // namespace capcon
