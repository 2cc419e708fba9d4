#include "points/point_set.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iterator>

#include "base/error.h"
#include "base/file.h"

namespace capcon {

namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

std::string_view trimmed(std::string_view line) {
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
  return line;
}

/// Takes the first word off the line.
std::string_view next_word(std::string_view& line) {
  line = trimmed(line);
  std::size_t length = 0;
  while (length < line.size() && !is_blank(line[length])) ++length;
  const std::string_view word = line.substr(0, length);
  line.remove_prefix(length);
  return word;
}

double coordinate(std::string_view word, const SourcePlace& place) {
  double value = 0;
  // from_chars takes no '+', which other writers do put.
  const char* begin = word.data() + (word.size() > 1 && word[0] == '+' && word[1] != '-' ? 1 : 0);
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error == std::errc::result_out_of_range && stop == end) {
    // Too small for a double is as good as 0; too large is out of the square anyway.
    value = std::strtod(std::string(begin, end).c_str(), nullptr);
  } else if (error != std::errc() || stop != end) {
    throw InputError(place, fmt::format("\"{}\" is not a number; a line holds two coordinates, \"x y\"",
                                        word.substr(0, 40)));
  }
  if (!(value >= 0 && value <= 1)) {  // NaN too
    throw InputError(place,
                     fmt::format("{} is not in [0, 1]; points live in the unit square", word.substr(0, 40)));
  }
  return value == 1 ? 0.0 : value + 0.0;  // -0 becomes 0
}

}  // namespace

std::vector<Points> parse_points(std::string_view text, const std::string& name) {
  std::vector<Points> sets(1);
  SourcePlace place{name, 0, 0};
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    std::string_view line = trimmed(text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
    ++place.line;
    if (line.empty()) continue;
    if (line == "#") {
      if (sets.back().empty()) throw InputError(place, "a set without points; remove this '#'");
      sets.emplace_back();
      continue;
    }
    const std::string_view first = next_word(line);
    const std::string_view second = next_word(line);
    if (second.empty()) throw InputError(place, "one coordinate is missing; a line holds two, \"x y\"");
    if (!trimmed(line).empty())
      throw InputError(place, "more than two coordinates; a line holds two, \"x y\"");
    const double x = coordinate(first, place);
    sets.back().emplace_back(x, coordinate(second, place));
  }
  if (sets.back().empty()) sets.pop_back();
  if (sets.empty()) throw InputError({name, 0, 0}, "holds no points; expected lines of \"x y\"");
  return sets;
}

std::vector<Points> read_points(const std::filesystem::path& path) {
  return parse_points(read_file(path), path.string());
}

std::string format_points(const std::vector<Points>& sets) {
  std::string text;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    if (s > 0) text += "#\n";
    for (const glm::dvec2& p : sets[s]) {
      fmt::format_to(std::back_inserter(text), FMT_COMPILE("{:.17g} {:.17g}\n"), p.x, p.y);
    }
  }
  return text;
}

void write_points(const std::filesystem::path& path, const std::vector<Points>& sets) {
  write_file(path, format_points(sets));
}

}  // namespace capcon
