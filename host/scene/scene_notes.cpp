#include "scene/scene_notes.h"

namespace capcon {

void SceneNotes::add(NoteKind kind, const SourcePlace& place, const std::string& sentence) {
  const auto [found, is_new] = places_.emplace(std::pair(kind, one_line(sentence)), notes_.size());
  if (is_new) {
    notes_.push_back({kind, found->first.second, place});
  } else {
    ++notes_[found->second].count;
  }
}

void SceneNotes::add_warning(const SourcePlace& place, const std::string& sentence) {
  const bool gone = sentence.find("left out") != std::string::npos;
  add(gone ? NoteKind::left_out : NoteKind::approximated, place, sentence);
}

}  // namespace capcon
