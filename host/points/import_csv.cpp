#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/error.h"
#include "points/import_points.h"

namespace capcon {

namespace {

std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// The fields of a line; blanks count as one separator however many there are.
std::vector<std::string_view> fields_of(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t end = separator == ' ' ? line.find_first_of(" \t") : line.find(separator);
    fields.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
    if (separator == ' ') line = trimmed(line);
  }
}

/// False for what is not a number.
bool to_number(std::string_view field, bool decimal_comma, double& value) {
  std::string text(field);
  if (text.size() > 1 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  if (decimal_comma) std::replace(text.begin(), text.end(), ',', '.');
  const char* const begin = text.data() + (text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0);
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error == std::errc::result_out_of_range && stop == end) value = std::strtod(begin, nullptr);
  return error != std::errc::invalid_argument && stop == end;
}

double coordinate(std::string_view field, bool decimal_comma, const SourcePlace& place) {
  double value = 0;
  if (!to_number(field, decimal_comma, value))
    throw InputError(
        place, fmt::format("\"{}\" is not a number; a line holds two coordinates", field.substr(0, 40)));
  if (!(value >= 0 && value <= 1))
    throw InputError(place,
                     fmt::format("{} is not in [0, 1]; points live in the unit square", field.substr(0, 40)));
  return value == 1 ? 0.0 : value + 0.0;
}

}  // namespace

std::vector<Points> parse_csv_points(std::string_view text, const std::string& name) {
  if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);  // a mark that some programs put first
  Points points;
  SourcePlace place{name, 0, 0};
  char separator = '\0';
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
    ++place.line;
    if (line.empty()) continue;
    const bool first = separator == '\0';
    if (first) {
      separator = line.find(';') != line.npos ? ';' : line.find(',') != line.npos ? ',' : ' ';
    }
    const std::vector<std::string_view> fields = fields_of(line, separator);
    const bool decimal_comma = separator == ';';
    if (fields.size() != 2) {
      throw InputError(place, fmt::format("{} column{} where two are expected, x and y", fields.size(),
                                          fields.size() == 1 ? "" : "s"));
    }
    double ignored;
    if (first && !to_number(fields[0], decimal_comma, ignored) &&
        !to_number(fields[1], decimal_comma, ignored))
      continue;  // names
    const double x = coordinate(fields[0], decimal_comma, place);
    points.emplace_back(x, coordinate(fields[1], decimal_comma, place));
  }
  if (points.empty()) throw InputError({name, 0, 0}, "holds no points; expected lines of \"x, y\"");
  return {points};
}

}  // namespace capcon
