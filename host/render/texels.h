#pragma once

#include <bit>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace capcon {

/// A double as the bits of its float.
inline std::uint32_t float_bits(double v) {
  return std::bit_cast<std::uint32_t>(static_cast<float>(v));
}

/// Three floats and a word, or four floats, as a texel of the device's buffers.
inline glm::uvec4 make_texel(const glm::dvec3& v, std::uint32_t w) {
  return {float_bits(v.x), float_bits(v.y), float_bits(v.z), w};
}
inline glm::uvec4 make_texel(const glm::dvec3& v, double w) {
  return make_texel(v, float_bits(w));
}

}  // namespace capcon
