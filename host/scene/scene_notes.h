#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace capcon {

enum class NoteKind : std::uint8_t {
  approximated,  ///< there, yet not as the file has it
  left_out,      ///< not there
  unused         ///< says nothing here: a parameter that is not read, or what the command line decides
};

/// Something that a scene file asks for and does not get.
struct SceneNote {
  NoteKind kind = NoteKind::left_out;
  std::string sentence;
  SourcePlace place;  ///< the first
  std::uint64_t count = 1;
};

/// Everything that reading a scene has to say, each thing once with how often it came.
class SceneNotes {
 public:
  void add(NoteKind kind, const SourcePlace& place, const std::string& sentence);
  /// The kind is taken from the words of the reader's warning.
  void add_warning(const SourcePlace& place, const std::string& sentence);
  const std::vector<SceneNote>& all() const { return notes_; }

  /// What stops a render, with its place: the first is the sentence that a render ends with.
  std::vector<std::string> errors;

 private:
  std::vector<SceneNote> notes_;
  std::map<std::pair<NoteKind, std::string>, std::size_t> places_;
};

/// As read_scene() with everything read; goes on behind what is malformed or unknown, for a whole list.
/// InputError where there is no such file, or a bare mesh is broken.
Scene read_scene(const std::string& path, SceneNotes& notes);

}  // namespace capcon
