#pragma once

#include <string_view>
#include <vector>

namespace capcon {

/// Walks through the lines of a text. A line ends with "\n", "\r\n" or a lone "\r" that no "\n" follows, and
/// does not hold its end.
class TextLines {
 public:
  explicit TextLines(std::string_view bytes) : bytes_(bytes) {}
  /// Steps to the next line; false after the last.
  bool next();
  std::string_view line() const { return line_; }
  /// The number of the line, from 1.
  int number() const { return number_; }
  /// Where the next line starts in the bytes.
  std::size_t offset() const { return offset_; }

 private:
  std::string_view bytes_;
  std::string_view line_;
  std::size_t offset_ = 0;
  int number_ = 0;
};

/// The words of a line between blanks and tabs.
std::vector<std::string_view> split_words(std::string_view line);

}  // namespace capcon
