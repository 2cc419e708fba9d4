#pragma once

#include <string>
#include <string_view>

#include "scene/scene.h"
#include "scene/scene_notes.h"

namespace capcon {

/// Reads pbrt text (v4 names; v2 and v3 accepted) from memory, and the files it includes and names. `path` is
/// what messages call the text; files are named relative to its folder. No texture, environment map or
/// measured BRDF is opened here. InputError with file:line:column.
Scene parse_pbrt(std::string_view bytes, const std::string& path, const ReadOptions& options = {});

/// The same with everything read, and everything noted that is not as the file has it. What is malformed or
/// unknown is one of the notes' errors, and reading goes on behind it.
Scene parse_pbrt(std::string_view bytes, const std::string& path, SceneNotes& notes);

}  // namespace capcon
