#pragma once

#include <glm/vec2.hpp>
#include <string_view>
#include <vector>

namespace capcon::plot {

/// A small font of strokes, our own, for pictures of pixels: ASCII and the root sign; other characters become
/// a box. Lengths are in units of the font's size.

/// How far a text reaches from its start.
double text_width(std::string_view text);

/// The pen's ways: base line at y = 0, y upwards, a capital 0.72 high; curves as short straight pieces.
std::vector<std::vector<glm::dvec2>> text_strokes(std::string_view text);

}  // namespace capcon::plot
