#pragma once

#include <string_view>

#include "scene/pbrt_context.h"

namespace capcon {

/// Where the context takes notes: one for each parameter of `directive` ("Shape", "Material", ...) of that
/// type that is not read, known to pbrt or not. Types that are left out as a whole have said so.
void note_parameters(PbrtContext& context, std::string_view directive, std::string_view type,
                     const Parameters& parameters);

}  // namespace capcon
