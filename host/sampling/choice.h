#pragma once

#include <cstdint>

#include "sampling/sampler.h"

namespace capcon {

/// A random permutation of [0, count): place `index` goes to. Keyed rounds of multiplication and shift on the
/// next power of two, walked until the result is below count. Unlike shuffle_index it keeps no structure of
/// the order.
std::uint32_t permute(std::uint32_t index, std::uint32_t count, std::uint32_t key);

/// The number in [0, 1), as 0.32 fixed point, by which the component of a BSDF is chosen for point `index` of
/// part `part`: stratified in the part and in the whole set, in an order that has nothing to do with that of
/// the set's points. (The x of another 2D set has: of nets, points with small x are all in one half of the
/// other set for some counts.) `separate`: parts are sets of their own. Same bits in
/// shaders/sampling/choice.glsl.
std::uint32_t component_choice(std::uint32_t seed, std::uint32_t pixel, std::uint32_t part,
                               std::uint32_t index, const Split& split, bool separate);

/// Which point of its set a light path takes in a dimension pair of a bounce: any, by a random permutation of
/// each pair's own. The samplers' own orders will not do for what is multiplied: in sets that are stored by
/// place, blocks of neighbours stay together, and paths that start together would go on together. Same bits
/// in shaders/sampling/choice.glsl.
std::uint32_t path_point(std::uint32_t seed, std::uint32_t set, std::uint32_t path, std::uint32_t paths,
                         std::uint32_t bounce, std::uint32_t pair);

}  // namespace capcon
