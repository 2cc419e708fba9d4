#include <fmt/format.h>

#include "scene/known_parameters.h"
#include "scene/pbrt_directives.h"
#include "scene/pbrt_parameters.h"

namespace capcon {
namespace {

/// An entity at the directive, with what Attribute set for `target` added; that of a named material has no
/// type yet.
Entity make_entity(PbrtContext& context, Tokenizer& tokens, const Token& directive, std::string type,
                   const std::string& target) {
  Entity entity;
  entity.type = std::move(type);
  entity.parameters = read_parameters(tokens);
  const auto defaults = context.state.defaults.find(target);
  if (defaults != context.state.defaults.end())
    entity.parameters.entries.insert(defaults->second.entries.begin(), defaults->second.entries.end());
  const bool is_named = directive.text == "MakeNamedMaterial";
  const std::string of = is_named ? entity.parameters.string("type", {}) : entity.type;
  note_parameters(context, is_named ? "Material" : directive.text, of, entity.parameters);
  entity.to_world = context.state.to_world;
  entity.place = tokens.place(directive);
  return entity;
}

int last(const std::vector<Entity>& entities) {
  return static_cast<int>(entities.size()) - 1;
}

void material(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  std::string type = read_string(tokens, "Material");
  context.scene.materials.push_back(make_entity(context, tokens, directive, std::move(type), "material"));
  context.state.material = last(context.scene.materials);
}

void make_named_material(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  const SourcePlace place = tokens.place(directive);
  const std::string name = read_string(tokens, "MakeNamedMaterial");
  Entity entity = make_entity(context, tokens, directive, {}, "material");
  if (!entity.parameters.entries.contains("type")) {
    throw InputError(place, fmt::format("the named material \"{}\" needs its \"string type\"", name));
  }
  entity.type = entity.parameters.string("type", {});
  entity.name = name;
  if (context.missing_materials.erase(name) > 0) {  // shapes that came earlier point there already
    context.scene.materials[context.materials.at(name)] = std::move(entity);
    return;
  }
  if (context.materials.contains(name)) {
    context.warn(
        place,
        fmt::format("the material \"{}\" is defined again; shapes from here on use the new one", name));
  }
  context.scene.materials.push_back(std::move(entity));
  context.materials[name] = last(context.scene.materials);
}

void named_material(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  const std::string name = read_string(tokens, "NamedMaterial");
  for (const auto& [parameter, entry] :
       read_parameters(tokens).entries)  // pbrt-v2 has no use for them either
    context.note_unused(entry.place, fmt::format("\"{}\" of NamedMaterial is not used", parameter));
  const auto [found, is_new] =
      context.materials.emplace(name, static_cast<int>(context.scene.materials.size()));
  if (is_new) {  // to be defined behind its use, as pbrt-v4 allows
    context.missing_materials.emplace(name, tokens.place(directive));
    context.scene.materials.emplace_back();
  }
  context.state.material = found->second;
}

/// Whether a texture is an image of the base colour or a mean is said where it is used; others never are
/// more.
void note_texture(PbrtContext& context, const Entity& texture) {
  for (const char* known : {"constant", "imagemap", "scale", "mix", "checkerboard"}) {
    if (texture.type == known) return;
  }
  if (context.notes) {
    context.notes->add(NoteKind::approximated, texture.place,
                       fmt::format("textures \"{}\" are constants wherever they are used", texture.type));
  }
}

void texture(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  const std::string name = read_string(tokens, "Texture");
  const Token value_type = tokens.peek();
  const std::string values = read_string(tokens, "Texture");
  if (values != "float" && values != "spectrum" && values != "color") {
    throw InputError(
        tokens.place(value_type),
        fmt::format("the texture \"{}\" must be of \"float\" or \"spectrum\", not \"{}\"", name, values));
  }
  std::string type = read_string(tokens, "Texture");
  Entity entity = make_entity(context, tokens, directive, std::move(type), "texture");
  entity.name = name;
  entity.values = values == "float" ? "float" : "spectrum";
  note_texture(context, entity);
  context.scene.textures.push_back(std::move(entity));
}

void light_source(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  std::string type = read_string(tokens, "LightSource");
  context.scene.lights.push_back(make_entity(context, tokens, directive, std::move(type), "light"));
}

void area_light_source(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  std::string type = read_string(tokens, "AreaLightSource");
  context.scene.area_lights.push_back(make_entity(context, tokens, directive, std::move(type), "light"));
  context.state.area_light = last(context.scene.area_lights);
}

/// Media do not exist here: rays travel through a vacuum.
void medium(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  read_string(tokens, std::string(directive.text).c_str());
  // MediumInterface names one medium or two, without a type before the second.
  const bool interface = directive.text == "MediumInterface";
  if (interface && tokens.peek().kind == TokenKind::string) tokens.next();
  if (!interface) read_parameters(tokens);
  context.warn(tokens.place(directive), "media are left out: space is empty");
}

}  // namespace

const std::vector<PbrtDirective>& pbrt_appearance_directives() {
  static const std::vector<PbrtDirective> kDirectives = {
      {"Material", PbrtPhase::world, material},
      {"MakeNamedMaterial", PbrtPhase::world, make_named_material},
      {"NamedMaterial", PbrtPhase::world, named_material},
      {"Texture", PbrtPhase::world, texture},
      {"LightSource", PbrtPhase::world, light_source},
      {"AreaLightSource", PbrtPhase::world, area_light_source},
      {"MakeNamedMedium", PbrtPhase::both, medium},
      {"MediumInterface", PbrtPhase::both, medium},
      {"Volume", PbrtPhase::world, medium},
  };
  return kDirectives;
}

}  // namespace capcon
