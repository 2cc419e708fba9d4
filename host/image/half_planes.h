#pragma once

#include <string>
#include <vector>

#include "image/image.h"

namespace capcon {

/// Linear images for pages, small and without loss beside 11 bits of a value: all pixels of all images as
/// 16-bit floats (half), the high bytes of all of them before the low bytes, deflated (zlib's format, RFC
/// 1950).
std::string half_planes(const std::vector<const Image*>& images);

}  // namespace capcon
