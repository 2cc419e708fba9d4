#include <fmt/format.h>

#include <algorithm>

#include "scene/pbrt_directives.h"
#include "scene/pbrt_parameters.h"
#include "scene/suggestion.h"

namespace capcon {
namespace {

void world_begin(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  if (context.in_world)
    throw InputError(tokens.place(directive), "this is the second WorldBegin; a scene has one world");
  context.in_world = true;
  context.state.to_world = glm::dmat4(1);
  context.state.start_active = true;
  context.coordinate_systems["world"] = glm::dmat4(1);
}

void world_end(PbrtContext& context, Tokenizer& tokens, const Token&) {
  context.ended = true;
  if (tokens.peek().kind != TokenKind::end)
    context.warn(tokens.place(tokens.peek()), "what follows WorldEnd is left out");
}

void push(PbrtContext& context, const Tokenizer& tokens, const Token& directive) {
  context.scopes.push_back({std::string(directive.text), tokens.place(directive), context.state});
}

void pop(PbrtContext& context, const Tokenizer& tokens, const Token& directive, const char* begin) {
  if (context.scopes.empty()) {
    throw InputError(tokens.place(directive), fmt::format("{} has no {} before it", directive.text, begin));
  }
  context.state = std::move(context.scopes.back().state);
  context.scopes.pop_back();
}

void attribute_begin(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  push(context, tokens, directive);
}

void attribute_end(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  pop(context, tokens, directive, "AttributeBegin");
}

void attribute(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  static const std::vector<std::string_view> kTargets = {"shape", "light", "material", "medium", "texture"};
  const std::string target = read_string(tokens, "Attribute");
  if (std::find(kTargets.begin(), kTargets.end(), target) == kTargets.end()) {
    throw InputError(tokens.place(directive),
                     fmt::format("Attribute knows no target \"{}\"{}", target, suggestion(target, kTargets)));
  }
  const Parameters parameters = read_parameters(tokens);
  if (target == "medium") context.warn(tokens.place(directive), "media are left out: space is empty");
  for (const auto& [name, entry] : parameters.entries)
    context.state.defaults[target].entries.insert_or_assign(name, entry);
}

void reverse_orientation(PbrtContext& context, Tokenizer&, const Token&) {
  context.state.reverse_orientation = !context.state.reverse_orientation;
}

void object_begin(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  const SourcePlace place = tokens.place(directive);
  const std::string name = read_string(tokens, "ObjectBegin");
  if (context.object)
    throw InputError(place, "ObjectBegin inside an object; close the outer one with ObjectEnd first");
  push(context, tokens, directive);
  if (context.objects.contains(name)) {
    context.warn(
        place,
        fmt::format("the object \"{}\" is defined again; instances from here on use the new one", name));
  }
  context.object = context.objects[name] = static_cast<std::uint32_t>(context.scene.objects.size());
  context.object_place = place;
  context.scene.objects.push_back({name, {}});
}

void object_end(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  if (!context.object) throw InputError(tokens.place(directive), "ObjectEnd has no ObjectBegin before it");
  pop(context, tokens, directive, "ObjectBegin");
  context.object.reset();
}

void object_instance(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  const SourcePlace place = tokens.place(directive);
  const std::string name = read_string(tokens, "ObjectInstance");
  if (context.object) throw InputError(place, "ObjectInstance inside an object: objects hold shapes only");
  const auto found = context.objects.find(name);
  if (found == context.objects.end()) {
    std::vector<std::string_view> names;
    for (const auto& known : context.objects) names.push_back(known.first);
    throw InputError(place, fmt::format("there is no object named \"{}\"{}", name, suggestion(name, names)));
  }
  context.scene.instances.push_back({found->second, context.state.to_world});
}

}  // namespace

const std::vector<PbrtDirective>& pbrt_scope_directives() {
  static const std::vector<PbrtDirective> kDirectives = {
      {"WorldBegin", PbrtPhase::both, world_begin},
      {"WorldEnd", PbrtPhase::world, world_end},
      {"AttributeBegin", PbrtPhase::world, attribute_begin},
      {"AttributeEnd", PbrtPhase::world, attribute_end},
      {"Attribute", PbrtPhase::world, attribute},
      {"ReverseOrientation", PbrtPhase::world, reverse_orientation},
      {"ObjectBegin", PbrtPhase::world, object_begin},
      {"ObjectEnd", PbrtPhase::world, object_end},
      {"ObjectInstance", PbrtPhase::world, object_instance},
  };
  return kDirectives;
}

}  // namespace capcon
