#include "scene/text_lines.h"

#include <algorithm>

namespace capcon {

bool TextLines::next() {
  if (offset_ >= bytes_.size()) return false;
  const std::size_t end = std::min(bytes_.find_first_of("\r\n", offset_), bytes_.size());
  line_ = bytes_.substr(offset_, end - offset_);
  offset_ = end + (bytes_.substr(end, 2) == "\r\n" ? 2 : 1);
  offset_ = std::min(offset_, bytes_.size());
  ++number_;
  return true;
}

std::vector<std::string_view> split_words(std::string_view line) {
  std::vector<std::string_view> words;
  constexpr std::string_view kBlanks = " \t\f\v";
  for (std::size_t start = line.find_first_not_of(kBlanks); start != line.npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, start), line.size());
    words.push_back(line.substr(start, end - start));
    start = line.find_first_not_of(kBlanks, end);
  }
  return words;
}

}  // namespace capcon
