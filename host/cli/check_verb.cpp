#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "cli/verbs.h"
#include "shading/scene_check.h"
#include "study/format.h"

namespace capcon::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string scene, integrator = "ao";
  bool json = false;
};

/// How many of each type.
Json types_of(const std::vector<Entity>& entities) {
  Json types = Json::object();
  for (const Entity& entity : entities) {
    const std::string type = entity.type.empty() ? "none" : entity.type;
    types[type] = types.value(type, 0) + 1;
  }
  return types;
}

void count_shapes(const std::vector<Shape>& shapes, Json& counts) {
  for (const Shape& shape : shapes) {
    const char* kind = shape.kind == ShapeKind::mesh     ? "mesh"
                       : shape.kind == ShapeKind::sphere ? "sphere"
                                                         : "disk";
    counts[kind] = counts.value(kind, 0) + 1;
  }
}

/// What is there; area lights by the shapes that have one.
Json contents_of(const Scene& scene) {
  Json shapes = Json::object(), area_lights = Json::object();
  count_shapes(scene.shapes, shapes);
  count_shapes(scene.hidden_shapes, shapes);
  for (const Object& object : scene.objects) count_shapes(object.shapes, shapes);
  for (const auto* list : {&scene.shapes, &scene.hidden_shapes}) {
    for (const Shape& shape : *list) {
      if (shape.area_light < 0) continue;
      const std::string& type = scene.area_lights[shape.area_light].type;
      area_lights[type] = area_lights.value(type, 0) + 1;
    }
  }
  Json images = Json::object();
  for (const SceneImage& image : scene.images)
    images[image.file] = fmt::format("{}x{}", image.image.width, image.image.height);
  return {{"film", fmt::format("{}x{}", scene.film.width, scene.film.height)},
          {"camera", fmt::format("perspective, {:.4g} degrees", scene.camera.fov_degrees)},
          {"shapes", shapes},
          {"triangles", scene.unique_triangles()},
          {"objects", scene.objects.size()},
          {"instances", scene.instances.size()},
          {"triangles_with_instances", scene.instanced_triangles()},
          {"materials", types_of(scene.materials)},
          {"textures", types_of(scene.textures)},
          {"lights", types_of(scene.lights)},
          {"area_lights", area_lights},
          {"images", images}};
}

std::string text_of(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number()) return grouped(value.get<std::uint64_t>());
  std::string text;
  for (const auto& [name, count] : value.items()) {
    const std::string one = count.is_string()
                                ? fmt::format("{} ({})", name, count.get<std::string>())
                                : fmt::format("{} {}", grouped(count.get<std::uint64_t>()), name);
    text += (text.empty() ? "" : ", ") + one;
  }
  return text.empty() ? "none" : text;
}

std::string_view name_of(NoteKind kind) {
  return kind == NoteKind::approximated ? "approximated" : kind == NoteKind::left_out ? "left_out" : "unused";
}

/// Notes of a kind, the most frequent first.
std::vector<SceneNote> notes_of(const SceneCheck& check, NoteKind kind) {
  std::vector<SceneNote> notes;
  for (const SceneNote& note : check.notes.all()) {
    if (note.kind == kind) notes.push_back(note);
  }
  std::stable_sort(notes.begin(), notes.end(),
                   [](const SceneNote& a, const SceneNote& b) { return a.count > b.count; });
  return notes;
}

/// Who can render it, and what it looks like without lights.
Json integrators_of(const SceneCheck& check) {
  const std::string seen = check.can_be_seen() ? "yes" : check.notes.errors.front();
  std::string shaded = seen;
  if (check.can_be_seen() && !check.can_be_shaded()) shaded = check.shading_errors.front();
  Json result = {{"ao", seen}, {"direct", shaded}, {"igi", shaded}, {"path", shaded}};
  if (check.can_be_shaded() && check.lights == 0) {
    result["direct"] = result["path"] = "yes, yet it has no light and is black";
    result["igi"] = "it has no light that virtual point lights could come from";
  }
  return result;
}

bool is_yes(const Json& integrators, const std::string& name) {
  return integrators.at(name).get<std::string>().starts_with("yes");
}

std::string to_text(const Options& o, const SceneCheck& check, const Json& integrators) {
  std::string text = o.scene + "\n";
  const Json contents = contents_of(check.scene);
  for (const auto& [name, value] : contents.items()) {
    std::string label = name;
    std::replace(label.begin(), label.end(), '_', ' ');
    text += fmt::format("  {:<26}{}\n", label, text_of(value));
  }
  const std::pair<NoteKind, const char*> kinds[] = {{NoteKind::approximated, "Approximated"},
                                                    {NoteKind::left_out, "Not supported, and left out"},
                                                    {NoteKind::unused, "Not used"}};
  for (const auto& [kind, title] : kinds) {
    const std::vector<SceneNote> notes = notes_of(check, kind);
    if (notes.empty()) continue;
    text += fmt::format("{}\n", title);
    for (const SceneNote& note : notes) {
      text += fmt::format("  {:>6} {}  [{}{}]\n", grouped(note.count) + "x", note.sentence,
                          note.count > 1 ? "first: " : "", note.place.str());
    }
  }
  const auto add_errors = [&](const char* title, const std::vector<std::string>& errors) {
    if (!errors.empty()) text += fmt::format("{}\n", title);
    for (const std::string& error : errors) text += fmt::format("  {}\n", error);
  };
  add_errors("Stops every render", check.notes.errors);
  add_errors("Stops renders that need materials and lights", check.shading_errors);
  text += "Can be rendered by\n";
  for (const auto& [name, value] : integrators.items())
    text +=
        fmt::format("  {:<8}{}\n", name,
                    is_yes(integrators, name) ? value.get<std::string>() : "no: " + value.get<std::string>());
  return text;
}

Json to_json(const Options& o, const SceneCheck& check, const Json& integrators) {
  Json json = {{"scene", o.scene}, {"contents", contents_of(check.scene)}};
  for (const NoteKind kind : {NoteKind::approximated, NoteKind::left_out, NoteKind::unused}) {
    Json list = Json::array();
    for (const SceneNote& note : notes_of(check, kind))
      list.push_back({{"what", note.sentence}, {"count", note.count}, {"first", note.place.str()}});
    json[std::string(name_of(kind))] = list;
  }
  json["errors"] = check.notes.errors;
  json["shading_errors"] = check.shading_errors;
  json["integrators"] = integrators;
  return json;
}

void run(const Options& o) {
  const SceneCheck check = check_scene(o.scene);
  const Json integrators = integrators_of(check);
  fmt::print("{}", o.json ? to_json(o, check, integrators).dump(2) + "\n" : to_text(o, check, integrators));
  if (is_yes(integrators, o.integrator)) return;
  std::fflush(stdout);
  throw InputError(integrators.at(o.integrator).get<std::string>());
}

}  // namespace

void add_check_verb(CLI::App& app) {
  CLI::App* verb =
      app.add_subcommand("check",
                         "say what of a scene is rendered, what is approximated and what is left out\n\n"
                         "  capcon check scene.pbrt\n"
                         "  capcon check scene.pbrt --integrator igi --json\n\n"
                         "Exit code 2 where it cannot be rendered.\n");
  auto o = std::make_shared<Options>();
  verb->add_option("scene", o->scene, ".pbrt (v4, v3 or v2 text), .ply or .obj")->required();
  verb->add_option("--integrator", o->integrator, "the exit code is for this one")
      ->capture_default_str()
      ->check(CLI::IsMember({"ao", "direct", "igi", "path"}));
  verb->add_flag("--json", o->json, "print one JSON object");
  verb->callback([o] { run(*o); });
}

}  // namespace capcon::cli
