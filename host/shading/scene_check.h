#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/scene_notes.h"

namespace capcon {

/// What the renderers make of a scene.
struct SceneCheck {
  Scene scene;
  /// What is approximated, left out or not used, of geometry, materials and lights. Its errors stop every
  /// integrator.
  SceneNotes notes;
  std::size_t lights = 0;                   ///< that emit, area lights of shapes among them
  std::vector<std::string> shading_errors;  ///< what stops those that need materials and lights

  bool can_be_seen() const { return notes.errors.empty(); }
  bool can_be_shaded() const { return can_be_seen() && shading_errors.empty(); }
};

/// Reads the scene as the integrators do, all of them together, and goes on behind errors for a whole list.
/// InputError where there is no such file.
SceneCheck check_scene(const std::string& path);

}  // namespace capcon
