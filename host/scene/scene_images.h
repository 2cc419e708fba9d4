#pragma once

#include "scene/pbrt_context.h"

namespace capcon {

/// Reads the pixels of image textures ("string filename") and environment lights ("filename", in pbrt-v2 and
/// v3 "mapname"): EXR and PNG, each file once, all threads. What is missing or of another format is said in
/// the scene's warnings, and the entity keeps no image. InputError for a broken file.
void read_scene_images(PbrtContext& context);

}  // namespace capcon
