#pragma once

#include <string>
#include <string_view>

#include "scene/scene.h"

namespace capcon {

/// Reads pbrt text (v4 names; v2 and v3 accepted) from memory, and the files it includes and names. `path` is
/// what messages call the text; files are named relative to its folder. No texture, environment map or
/// measured BRDF is opened here. InputError with file:line:column.
Scene parse_pbrt(std::string_view bytes, const std::string& path, const ReadOptions& options = {});

}  // namespace capcon
