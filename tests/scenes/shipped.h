// The shipped scenes by the names of their files.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "generator/atelier.h"
#include "generator/courtyard.h"
#include "generator/nave.h"
#include "generator/terrace.h"

namespace capcon {

inline const auto kShippedScenes = testing::Values("courtyard", "nave", "direct", "splitting");

inline scenes::Assembly shipped_scene(const std::string& name) {
  if (name == "nave") return scenes::nave();
  if (name == "direct") return scenes::atelier();
  if (name == "splitting") return scenes::terrace();
  return scenes::courtyard(1);
}

}  // namespace capcon
