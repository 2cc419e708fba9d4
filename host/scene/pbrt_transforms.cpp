#include <fmt/format.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "scene/pbrt_directives.h"
#include "scene/pbrt_parameters.h"
#include "scene/suggestion.h"
#include "scene/transform.h"

namespace capcon {
namespace {

/// Makes `transform` the current one, if the start time is active.
void set(PbrtContext& context, const SourcePlace& place, const glm::dmat4& transform) {
  if (!context.state.start_active) return;
  if (is_singular(transform)) {
    throw InputError(place,
                     "the current transform cannot be inverted from here on: it flattens space, or its "
                     "numbers are too extreme");
  }
  context.state.to_world = transform;
}

void concatenate(PbrtContext& context, const SourcePlace& place, const glm::dmat4& transform) {
  set(context, place, context.state.to_world * transform);
}

void identity(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  set(context, tokens.place(directive), glm::dmat4(1));
}

void translate(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  const std::vector<double> n = read_numbers(tokens, 3, "Translate");
  glm::dmat4 transform(1);
  transform[3] = glm::dvec4(n[0], n[1], n[2], 1);
  concatenate(context, tokens.place(directive), transform);
}

void scale(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  const std::vector<double> n = read_numbers(tokens, 3, "Scale");
  glm::dmat4 transform(1);
  for (int axis = 0; axis < 3; ++axis) transform[axis][axis] = n[axis];
  concatenate(context, tokens.place(directive), transform);
}

void rotate(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  const std::vector<double> n = read_numbers(tokens, 4, "Rotate");
  if (n[1] == 0 && n[2] == 0 && n[3] == 0) {
    throw InputError(tokens.place(directive), "Rotate needs an axis that is not 0 0 0");
  }
  concatenate(context, tokens.place(directive), rotation(n[0], {n[1], n[2], n[3]}));
}

void look(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  const std::vector<double> n = read_numbers(tokens, 9, "LookAt");
  const glm::dmat4 transform = look_at({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]});
  if (is_singular(transform)) {
    throw InputError(tokens.place(directive),
                     "LookAt needs an eye apart from its target, and an up that is not along the view");
  }
  concatenate(context, tokens.place(directive), transform);
}

/// Sixteen numbers column by column: the translation comes last.
glm::dmat4 read_matrix(Tokenizer& tokens, const Token& directive) {
  const std::string name(directive.text);
  const std::vector<double> n = read_numbers(tokens, 16, name.c_str());
  glm::dmat4 transform = glm::make_mat4(n.data());
  if (!is_affine(transform)) {
    throw InputError(
        tokens.place(directive),
        name + " wants an affine matrix, column by column: its numbers 4, 8 and 12 are 0, its last is 1");
  }
  for (int column = 0; column < 4; ++column) transform[column][3] = column == 3;
  return transform;
}

void transform(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  set(context, tokens.place(directive), read_matrix(tokens, directive));
}

void concat_transform(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  concatenate(context, tokens.place(directive), read_matrix(tokens, directive));
}

void coordinate_system(PbrtContext& context, Tokenizer& tokens, const Token&) {
  context.coordinate_systems[read_string(tokens, "CoordinateSystem")] = context.state.to_world;
}

void coord_sys_transform(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  const std::string name = read_string(tokens, "CoordSysTransform");
  const auto found = context.coordinate_systems.find(name);
  if (found == context.coordinate_systems.end()) {
    std::vector<std::string_view> names;
    for (const auto& known : context.coordinate_systems) names.push_back(known.first);
    throw InputError(tokens.place(directive),
                     fmt::format("there is no coordinate system \"{}\"{}", name, suggestion(name, names)));
  }
  set(context, tokens.place(directive), found->second);
}

void active_transform(PbrtContext& context, Tokenizer& tokens, const Token&) {
  const Token which = tokens.next();
  if (which.kind != TokenKind::word ||
      (which.text != "All" && which.text != "StartTime" && which.text != "EndTime")) {
    throw InputError(tokens.place(which),
                     fmt::format("ActiveTransform wants StartTime, EndTime or All, not {}", shown(which)));
  }
  context.state.start_active = which.text != "EndTime";
  if (which.text != "All")
    context.warn(tokens.place(which), "motion is left out: everything stands where it starts");
}

void transform_times(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  read_numbers(tokens, 2, "TransformTimes");
  context.note_unused(tokens.place(directive), "TransformTimes is not used: nothing moves");
}

void transform_begin(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  context.transform_scopes.push_back({"TransformBegin", tokens.place(directive), context.state});
}

void transform_end(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  if (context.transform_scopes.empty())
    throw InputError(tokens.place(directive), "TransformEnd has no TransformBegin before it");
  context.state.to_world = context.transform_scopes.back().state.to_world;
  context.state.start_active = context.transform_scopes.back().state.start_active;
  context.transform_scopes.pop_back();
}

}  // namespace

const std::vector<PbrtDirective>& pbrt_transform_directives() {
  static const std::vector<PbrtDirective> kDirectives = {
      {"Identity", PbrtPhase::both, identity},
      {"Translate", PbrtPhase::both, translate},
      {"Scale", PbrtPhase::both, scale},
      {"Rotate", PbrtPhase::both, rotate},
      {"LookAt", PbrtPhase::both, look},
      {"Transform", PbrtPhase::both, transform},
      {"ConcatTransform", PbrtPhase::both, concat_transform},
      {"CoordinateSystem", PbrtPhase::both, coordinate_system},
      {"CoordSysTransform", PbrtPhase::both, coord_sys_transform},
      {"ActiveTransform", PbrtPhase::both, active_transform},
      {"TransformTimes", PbrtPhase::options, transform_times},
      {"TransformBegin", PbrtPhase::both, transform_begin},
      {"TransformEnd", PbrtPhase::both, transform_end},
  };
  return kDirectives;
}

}  // namespace capcon
