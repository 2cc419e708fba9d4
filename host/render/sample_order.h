#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "sampling/sampler.h"

namespace capcon {

/// An order of a set's points, one texel each (the first word), in which neighbours lie close together in
/// every pixel: lanes that run in step then walk much the same nodes (docs/tracer.md has the gain). Empty
/// where there is none.
///
/// It is the Morton order of one pixel's points. For nets any pixel's will do: digit scrambling and Owen
/// scrambling permute the dyadic cells of a level among themselves, so that points that share a cell in one
/// pixel share one in all; points of pmj02 whose numbers are alike modulo 4^k share a cell of the 2^k x 2^k
/// grid in every sequence. Jittered strata stay where they are. The points of tiles and rotated sets lie in
/// such an order already, as far as a random shift leaves one, and independent points have none.
std::vector<glm::uvec4> sample_order(const Sampler& sampler);

}  // namespace capcon
