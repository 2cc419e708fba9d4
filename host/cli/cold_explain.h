#pragma once

#include "render/explain.h"

namespace capcon::cli {

/// explain() with the driver's shader cache switched off meanwhile: what compiling costs shows only when
/// there is nothing to remember. Before other threads are started.
Explanation cold_explain(const std::string& scene, int width, int height, const Job& job,
                         const RendererOptions& options, int repeats);

}  // namespace capcon::cli
