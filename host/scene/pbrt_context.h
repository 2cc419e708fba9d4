#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "scene/mesh_files.h"
#include "scene/pbrt_tokens.h"
#include "scene/scene.h"
#include "scene/scene_notes.h"

namespace capcon {

/// What AttributeBegin saves and AttributeEnd brings back.
struct PbrtState {
  glm::dmat4 to_world{1};    ///< the current transform (of the start time)
  bool start_active = true;  ///< ActiveTransform: whether transforms change `to_world`
  bool reverse_orientation = false;
  int material = -1;
  int area_light = -1;
  std::map<std::string, Parameters> defaults;  ///< of the Attribute directive, by target
};

/// An open AttributeBegin, ObjectBegin or TransformBegin.
struct PbrtScope {
  std::string directive;
  SourcePlace place;
  PbrtState state;
};

/// What is known while pbrt text is read. Directives are free functions on it, see pbrt_directives.h.
struct PbrtContext {
  Scene scene;
  ReadOptions options;
  std::filesystem::path folder;  ///< of the main file: other files are named relative to it
  PbrtState state;
  std::vector<PbrtScope> scopes;  ///< of attributes and objects; pbrt-v2/v3 files close them in any order
  std::vector<PbrtScope> transform_scopes;
  std::map<std::string, glm::dmat4> coordinate_systems;
  std::map<std::string, int> materials;                  ///< named ones, index into scene.materials
  std::map<std::string, SourcePlace> missing_materials;  ///< used before (or without) their definition
  std::map<std::string, std::uint32_t> objects;
  std::optional<std::uint32_t> object;  ///< the open one
  SourcePlace object_place;
  bool in_world = false;
  bool ended = false;
  MeshFiles files;
  std::vector<std::filesystem::path> includes;  ///< canonical, the file being read last
  std::set<std::string> warned;
  SceneNotes* notes = nullptr;  ///< where everything is noted, if that is wanted: `capcon check`

  /// Adds the sentence to the scene's warnings, unless it was there; and to the notes.
  void warn(const SourcePlace& place, const std::string& sentence);
  /// To the notes alone: what is not used here.
  void note_unused(const SourcePlace& place, const std::string& sentence);
  /// The path of a file that a scene names: relative to the main file's folder, or to that of the file that
  /// names it.
  std::filesystem::path resolve(const std::string& name, const SourcePlace& place) const;
};

}  // namespace capcon
