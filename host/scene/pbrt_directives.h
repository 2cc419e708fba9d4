#pragma once

#include <string_view>
#include <vector>

#include "scene/pbrt_context.h"

namespace capcon {

/// Where a directive may stand.
enum class PbrtPhase { options, world, both };

/// A directive of the language: `read` takes its arguments from the tokens and changes the context.
struct PbrtDirective {
  std::string_view name;
  PbrtPhase phase;
  void (*read)(PbrtContext&, Tokenizer&, const Token& directive);
};

/// The directives by family, each in its own file.
const std::vector<PbrtDirective>& pbrt_transform_directives();
const std::vector<PbrtDirective>& pbrt_option_directives();
const std::vector<PbrtDirective>& pbrt_scope_directives();
const std::vector<PbrtDirective>& pbrt_appearance_directives();
void read_pbrt_shape(PbrtContext& context, Tokenizer& tokens, const Token& directive);

}  // namespace capcon
