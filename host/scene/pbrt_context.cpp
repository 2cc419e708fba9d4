#include "scene/pbrt_context.h"

namespace capcon {

void PbrtContext::warn(const SourcePlace& place, const std::string& sentence) {
  if (notes) notes->add_warning(place, sentence);
  if (warned.insert(sentence).second) scene.warnings.push_back(one_line(place.str() + ": " + sentence));
}

void PbrtContext::note_unused(const SourcePlace& place, const std::string& sentence) {
  if (notes) notes->add(NoteKind::unused, place, sentence);
}

std::filesystem::path PbrtContext::resolve(const std::string& name, const SourcePlace& place) const {
  const std::filesystem::path named(name);
  if (named.is_absolute()) return named;
  const std::filesystem::path from_main = folder / named;
  std::error_code error;
  if (std::filesystem::exists(from_main, error)) return from_main;
  const std::filesystem::path from_here = std::filesystem::path(place.file).parent_path() / named;
  return std::filesystem::exists(from_here, error) ? from_here : from_main;
}

}  // namespace capcon
