#pragma once

#include <ImfHeader.h>

#include "image/image.h"

namespace capcon {

/// The header of our images: 32-bit float, ZIP, channels R G B (three) or Y (one), and the attributes.
Imf::Header exr_header(int width, int height, int channels, const Attributes& attributes);

/// "Y" of one channel; "R", "G", "B" of three.
const char* exr_channel(int channels, int index);

}  // namespace capcon
