#include "scene/pbrt_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "base/file.h"
#include "scene/pbrt_directives.h"
#include "scene/pbrt_parameters.h"
#include "scene/scene_images.h"
#include "scene/suggestion.h"

namespace capcon {
namespace {

constexpr std::size_t kDeepestInclude = 64;
constexpr std::size_t kMostErrors = 100;  // that `capcon check` lists

void read_tokens(PbrtContext& context, Tokenizer& tokens);

/// Reads another file in place of the directive.
void read_include(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  const SourcePlace place = tokens.place(directive);
  const std::filesystem::path path = context.resolve(read_string(tokens, "Include"), place);
  if (path.extension() == ".gz")
    throw InputError(place, "compressed files are not read; unpack \"" + path.string() + "\" with gunzip");
  std::error_code error;
  const std::filesystem::path canonical = std::filesystem::canonical(path, error);
  if (error || !std::filesystem::is_regular_file(canonical, error)) {
    throw InputError(place, "the file \"" + path.string() + "\" cannot be found");
  }
  if (std::find(context.includes.begin(), context.includes.end(), canonical) != context.includes.end()) {
    throw InputError(place,
                     "\"" + path.string() +
                         "\" is included while it is being read: the files include each other in a circle");
  }
  if (context.includes.size() > kDeepestInclude) {
    throw InputError(place, fmt::format("files are included more than {} deep", kDeepestInclude));
  }
  const std::string bytes = read_file(path);
  Tokenizer included(path.string(), bytes);
  context.includes.push_back(canonical);
  read_tokens(context, included);
  context.includes.pop_back();
}

/// As Include, but the file's changes to the current state stay inside it.
void read_import(PbrtContext& context, Tokenizer& tokens, const Token& directive) {
  const PbrtState state = context.state;
  read_include(context, tokens, directive);
  context.state = state;
}

using Table = std::unordered_map<std::string_view, PbrtDirective>;

const Table& table() {
  static const Table kTable = [] {
    Table table;
    for (const auto* family : {&pbrt_transform_directives(), &pbrt_option_directives(),
                               &pbrt_scope_directives(), &pbrt_appearance_directives()}) {
      for (const PbrtDirective& directive : *family) table.emplace(directive.name, directive);
    }
    for (const PbrtDirective& directive : {PbrtDirective{"Include", PbrtPhase::both, read_include},
                                           PbrtDirective{"Import", PbrtPhase::world, read_import},
                                           PbrtDirective{"Shape", PbrtPhase::world, read_pbrt_shape}}) {
      table.emplace(directive.name, directive);
    }
    return table;
  }();
  return kTable;
}

const PbrtDirective& find_directive(const PbrtContext& context, const Tokenizer& tokens, const Token& token) {
  if (token.kind != TokenKind::word) {
    throw InputError(tokens.place(token), fmt::format("a directive is wanted here, not {}", shown(token)));
  }
  const auto found = table().find(token.text);
  if (found == table().end()) {
    std::vector<std::string_view> names;
    for (const auto& entry : table()) names.push_back(entry.first);
    std::sort(names.begin(), names.end());
    throw InputError(tokens.place(token),
                     fmt::format("unknown directive {}{}", shown(token), suggestion(token.text, names)));
  }
  const PbrtPhase phase = found->second.phase;
  if (phase == PbrtPhase::world && !context.in_world) {
    throw InputError(tokens.place(token), fmt::format("{} belongs behind WorldBegin", token.text));
  }
  if (phase == PbrtPhase::options && context.in_world) {
    throw InputError(tokens.place(token), fmt::format("{} belongs before WorldBegin", token.text));
  }
  return found->second;
}

/// Goes on to the next word that is a directive's.
void skip_to_directive(Tokenizer& tokens) {
  while (tokens.peek().kind != TokenKind::end &&
         (tokens.peek().kind != TokenKind::word || !table().contains(tokens.peek().text)))
    tokens.next();
}

void read_tokens(PbrtContext& context, Tokenizer& tokens) {
  while (!context.ended) {
    try {
      const Token token = tokens.next();
      if (token.kind == TokenKind::end) return;
      find_directive(context, tokens, token).read(context, tokens, token);
    } catch (const InputError& error) {
      if (!context.notes || context.notes->errors.size() >= kMostErrors) throw;
      context.notes->errors.emplace_back(error.what());
      try {
        skip_to_directive(tokens);
      } catch (const InputError&) {
        return;  // a string that is not closed: there is no telling what follows
      }
    }
  }
}

/// Materials that are used and never defined: their shapes get the default, as in pbrt.
void settle_missing_materials(PbrtContext& context) {
  if (context.missing_materials.empty()) return;
  std::vector<std::string_view> names;
  for (const auto& material : context.materials) {
    if (!context.missing_materials.contains(material.first)) names.push_back(material.first);
  }
  std::vector<bool> missing(context.scene.materials.size());
  for (const auto& [name, place] : context.missing_materials) {
    missing[context.materials.at(name)] = true;
    context.warn(place, fmt::format("there is no material named \"{}\", the default is used{}", name,
                                    suggestion(name, names)));
  }
  std::vector<int> renumbered(missing.size(), -1);
  std::vector<Entity> kept;
  for (std::size_t i = 0; i < missing.size(); ++i) {
    if (missing[i]) continue;
    renumbered[i] = static_cast<int>(kept.size());
    kept.push_back(std::move(context.scene.materials[i]));
  }
  context.scene.materials = std::move(kept);
  const auto renumber = [&](std::vector<Shape>& shapes) {
    for (Shape& shape : shapes) {
      if (shape.material >= 0) shape.material = renumbered[shape.material];
    }
  };
  renumber(context.scene.shapes);
  renumber(context.scene.hidden_shapes);
  for (Object& object : context.scene.objects) renumber(object.shapes);
}

/// What can only be said at the end.
void finish(PbrtContext& context, const Tokenizer& tokens) {
  if (!context.in_world) throw InputError(SourcePlace{tokens.file()}, "this scene has no WorldBegin");
  if (context.object)
    throw InputError(context.object_place, "this ObjectBegin is never closed; add its ObjectEnd");
  for (const auto* scopes : {&context.scopes, &context.transform_scopes}) {
    if (scopes->empty()) continue;
    const PbrtScope& scope = scopes->back();
    const std::string stem =
        scope.directive.substr(0, scope.directive.size() - std::string_view("Begin").size());
    throw InputError(scope.place,
                     fmt::format("this {} is never closed; add its {}End", scope.directive, stem));
  }
  settle_missing_materials(context);
  context.files.load(context.scene.meshes, context.options);
  if (context.options.images) read_scene_images(context);
  const bool empty = context.scene.shapes.empty() && context.scene.instances.empty();
  if (empty) context.warn({tokens.file()}, "the scene has no shapes");
}

}  // namespace

namespace {

Scene parse(PbrtContext& context, std::string_view bytes, const std::string& path) {
  context.folder = std::filesystem::path(path).parent_path();
  context.scene.folder = context.folder.string();
  context.scene.name = std::filesystem::path(path).stem().string();
  std::error_code error;
  context.includes.push_back(std::filesystem::weakly_canonical(path, error));
  Tokenizer tokens(path, bytes);
  read_tokens(context, tokens);
  finish(context, tokens);
  return std::move(context.scene);
}

}  // namespace

Scene parse_pbrt(std::string_view bytes, const std::string& path, const ReadOptions& options) {
  PbrtContext context;
  context.options = options;
  return parse(context, bytes, path);
}

Scene parse_pbrt(std::string_view bytes, const std::string& path, SceneNotes& notes) {
  PbrtContext context;
  context.options = {.normals = true, .uvs = true, .images = true};
  context.notes = &notes;
  try {
    return parse(context, bytes, path);
  } catch (const InputError& error) {  // of the whole: a scope that is not closed, a broken file
    notes.errors.emplace_back(error.what());
    return std::move(context.scene);
  }
}

}  // namespace capcon
