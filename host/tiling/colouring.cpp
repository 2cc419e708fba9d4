#include "tiling/colouring.h"

#include <cassert>

#include "base/error.h"
#include "base/hash.h"
#include "tiling/region_layout.h"

namespace capcon {
namespace {

constexpr std::uint64_t kColourStream = 0x636f6c6f7572, kWishStream = 0x77697368, kShareSeed = 0x7368617265;
constexpr std::uint32_t kShareSide = 512, kBoundedShareSide = 8;

// What one vertex draws. No two vertices have the same priority: the last bits are the vertex.
struct Draw {
  std::uint64_t priority;
  std::uint32_t first, second;  ///< wishes; `second` is 0 where there is no other colour
};

Draw draw(std::uint64_t seed, std::uint32_t vertex, std::uint32_t colours) {
  const std::uint64_t bits = mix64(seed, kWishStream, vertex);
  const std::uint32_t wishes = colours - 1;
  Draw result{(mix64(seed, kWishStream + 1, vertex) & ~0xffffffffull) | vertex, 0, 0};
  if (wishes == 0) return result;
  result.first = 1 + std::uint32_t((bits >> 32) % wishes);
  if (wishes > 1)
    result.second = 1 + (result.first + std::uint32_t((bits & 0xffffffff) % (wishes - 1))) % wishes;
  return result;
}

std::vector<std::uint32_t> apart_colours(const GaussianTiling& tiling, std::uint32_t colours,
                                         std::uint64_t seed) {
  std::vector<Draw> draws(tiling.size());
  for (std::uint32_t v = 0; v < tiling.size(); ++v) draws[v] = draw(seed, v, colours);
  const auto no_neighbour = [&](std::uint32_t v, const auto& objects) {
    const glm::ivec2 at = tiling.cell(v);
    const std::uint32_t beside[] = {tiling.index(at.x - 1, at.y), tiling.index(at.x + 1, at.y),
                                    tiling.index(at.x, at.y - 1), tiling.index(at.x, at.y + 1)};
    for (const std::uint32_t u : beside)
      if (u == v || objects(u)) return false;  // on a torus of one tile a vertex is its own neighbour
    return true;
  };
  std::vector<std::uint32_t> first(tiling.size(), 0);
  for (std::uint32_t v = 0; v < tiling.size(); ++v)
    if (no_neighbour(v, [&](std::uint32_t u) {
          return draws[u].first == draws[v].first && draws[u].priority > draws[v].priority;
        }))
      first[v] = draws[v].first;
  std::vector<std::uint32_t> result = first;
  for (std::uint32_t v = 0; v < tiling.size(); ++v)
    if (first[v] == 0 && draws[v].second != 0 && no_neighbour(v, [&](std::uint32_t u) {
          const std::uint32_t wish = draws[v].second;
          return first[u] == wish ||
                 (first[u] == 0 && draws[u].second == wish && draws[u].priority > draws[v].priority);
        }))
      result[v] = draws[v].second;
  return result;
}

std::vector<std::uint32_t> bounded_colours(const GaussianTiling& tiling, std::uint32_t colours,
                                           std::uint64_t seed) {
  const std::uint32_t side = tiling.side();
  if (side < kLeastBoundedSide) throw InputError("a tiling with a border has k x k tiles, with k 2 or more");
  std::vector<std::uint32_t> result(tiling.size());
  for (std::uint32_t v = 0; v < tiling.size(); ++v) {
    const bool inside = v % side != 0 && v / side != 0;
    result[v] = inside ? std::uint32_t((mix64(seed, kColourStream, v) >> 32) % (colours - 1)) : colours - 1;
  }
  return result;
}

// Corners outside are those of the sides outside, and these are none, one, or two that meet.
bool is_bounded_tile(const std::array<std::uint32_t, 4>& corners, std::uint32_t outside) {
  const OutsideSides s = outside_sides(corners, outside);
  const auto is = [&](int corner, bool expected) { return (corners[corner] == outside) == expected; };
  return !(s.left && s.right) && !(s.bottom && s.top) && is(0, s.left || s.bottom) &&
         is(1, s.right || s.bottom) && is(2, s.left || s.top) && is(3, s.right || s.top);
}

std::vector<double> bounded_shares(std::uint32_t colours) {
  constexpr double kSide = kBoundedShareSide;
  std::vector<double> shares(tile_count(colours), 0.0);
  for (const std::uint32_t t : tile_numbers(colours, Colouring::bounded)) {
    const auto corners = tile_colours(colours, t);
    const int sides = outside_sides(corners, colours - 1).count();
    double cells = sides == 0 ? (kSide - 2) * (kSide - 2) : sides == 1 ? kSide - 2 : 1;
    for (const std::uint32_t c : corners)
      if (c != colours - 1) cells /= colours - 1;
    shares[t] = cells / (kSide * kSide);
  }
  return shares;
}

}  // namespace

std::string_view colouring_name(Colouring colouring) {
  return colouring == Colouring::free ? "free" : colouring == Colouring::apart ? "apart" : "bounded";
}

OutsideSides outside_sides(const std::array<std::uint32_t, 4>& corners, std::uint32_t outside) {
  const auto both = [&](int a, int b) { return corners[a] == outside && corners[b] == outside; };
  return {both(0, 2), both(1, 3), both(0, 1), both(2, 3)};
}

bool may_meet(Colouring colouring, std::uint32_t a, std::uint32_t b) {
  return colouring == Colouring::free || a != b || a == 0;
}

std::vector<std::uint32_t> tile_numbers(std::uint32_t colours, Colouring colouring) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t t = 0; t < tile_count(colours); ++t) {
    const auto c = tile_colours(colours, t);
    if (colouring == Colouring::bounded) {
      if (is_bounded_tile(c, colours - 1)) numbers.push_back(t);
      continue;
    }
    if (may_meet(colouring, c[0], c[1]) && may_meet(colouring, c[2], c[3]) &&
        may_meet(colouring, c[0], c[2]) && may_meet(colouring, c[1], c[3]))
      numbers.push_back(t);
  }
  return numbers;
}

std::vector<std::uint32_t> random_colours(const GaussianTiling& tiling, std::uint32_t colours,
                                          Colouring colouring, std::uint64_t seed) {
  assert(colours > 0);
  if (colouring == Colouring::apart) return apart_colours(tiling, colours, seed);
  if (colouring == Colouring::bounded) return bounded_colours(tiling, colours, seed);
  std::vector<std::uint32_t> result(tiling.size());
  for (std::uint32_t v = 0; v < tiling.size(); ++v)
    result[v] = std::uint32_t((mix64(seed, kColourStream, v) >> 32) % colours);
  return result;
}

std::vector<double> tile_shares(std::uint32_t colours, Colouring colouring) {
  const std::uint32_t count = tile_count(colours);
  if (colouring == Colouring::free) return std::vector<double>(count, 1.0 / count);
  if (colouring == Colouring::bounded) return bounded_shares(colours);
  const GaussianTiling tiling(kShareSide, 0);
  const auto drawn = random_colours(tiling, colours, colouring, kShareSeed);
  std::vector<double> shares(count, 0.0);
  for (std::uint32_t cell = 0; cell < tiling.size(); ++cell) {
    std::uint32_t tile = 0, digit = 1;
    for (const std::uint32_t vertex : tiling.corners(cell)) tile += drawn[vertex] * digit, digit *= colours;
    shares[tile] += 1.0 / tiling.size();
  }
  return shares;
}

}  // namespace capcon
