#include "scene/ply_header.h"

#include <fmt/format.h>

#include <charconv>

#include "base/error.h"
#include "scene/text_lines.h"

namespace capcon {
namespace {

PlyType parse_type(std::string_view text, const SourcePlace& place) {
  static constexpr struct {
    std::string_view name;
    PlyType type;
  } kNames[] = {
      {"char", PlyType::int8},       {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
      {"uint8", PlyType::uint8},     {"short", PlyType::int16},     {"int16", PlyType::int16},
      {"ushort", PlyType::uint16},   {"uint16", PlyType::uint16},   {"int", PlyType::int32},
      {"int32", PlyType::int32},     {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
      {"float", PlyType::float32},   {"float32", PlyType::float32}, {"double", PlyType::float64},
      {"float64", PlyType::float64},
  };
  for (const auto& known : kNames) {
    if (known.name == text) return known.type;
  }
  throw InputError(place, fmt::format("unknown PLY type \"{}\"", text));
}

PlyFormat parse_format(const std::vector<std::string_view>& words, const SourcePlace& place) {
  if (words.size() == 3 && words[2] == "1.0") {
    if (words[1] == "ascii") return PlyFormat::ascii;
    if (words[1] == "binary_little_endian") return PlyFormat::little_endian;
    if (words[1] == "binary_big_endian") return PlyFormat::big_endian;
  }
  throw InputError(place,
                   "the PLY format must be ascii, binary_little_endian or binary_big_endian, version 1.0");
}

PlyElement parse_element(const std::vector<std::string_view>& words, const SourcePlace& place) {
  PlyElement element;
  if (words.size() == 3) {
    element.name = words[1];
    const char* end = words[2].data() + words[2].size();
    const auto [stop, error] = std::from_chars(words[2].data(), end, element.count);
    if (error == std::errc{} && stop == end) return element;
  }
  throw InputError(place, "a PLY element is written \"element NAME COUNT\", with a count of 0 or more");
}

PlyProperty parse_property(const std::vector<std::string_view>& words, const SourcePlace& place) {
  PlyProperty property;
  if (words.size() == 3) {
    property.type = parse_type(words[1], place);
  } else if (words.size() == 5 && words[1] == "list") {
    property.is_list = true;
    property.count_type = parse_type(words[2], place);
    property.type = parse_type(words[3], place);
    if (property.count_type == PlyType::float32 || property.count_type == PlyType::float64) {
      throw InputError(place, "the length of a PLY list must be of an integer type");
    }
  } else {
    throw InputError(place,
                     "a PLY property is written \"property TYPE NAME\" or \"property list TYPE TYPE NAME\"");
  }
  property.name = words.back();
  return property;
}

/// The fewest bytes that one record of an element takes.
std::uint64_t smallest_record(const PlyElement& element, PlyFormat format) {
  std::uint64_t size = 0;
  for (const PlyProperty& property : element.properties) {
    if (format == PlyFormat::ascii) {
      size += 2;  // a digit and a blank
    } else {
      size += ply_size(property.is_list ? property.count_type : property.type);
    }
  }
  return size;
}

void check_counts(const PlyHeader& header, std::string_view bytes, const std::string& name) {
  std::uint64_t left = bytes.size() - header.data_start +
                       (header.format == PlyFormat::ascii);  // the last line may lack its end
  for (const PlyElement& element : header.elements) {
    if (element.properties.empty()) {
      throw InputError(fmt::format("{}: the PLY element \"{}\" has no properties", name, element.name));
    }
    const std::uint64_t size = smallest_record(element, header.format);
    if (element.count > left / size) {
      throw InputError(fmt::format(
          "{}: the header promises {} of \"{}\", but the file is too short for them; is it truncated?", name,
          element.count, element.name));
    }
    left -= element.count * size;
  }
}

}  // namespace

std::size_t ply_size(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      return 8;
  }
  return 8;
}

PlyHeader parse_ply_header(std::string_view bytes, const std::string& name) {
  PlyHeader header;
  TextLines lines(bytes);
  bool has_format = false;
  const auto place = [&] { return SourcePlace{name, lines.number(), 0}; };
  if (!lines.next() || split_words(lines.line()) != std::vector<std::string_view>{"ply"}) {
    throw InputError(SourcePlace{name, 1, 0}, "this is no PLY file: its first line is not \"ply\"");
  }
  while (lines.next()) {
    const std::vector<std::string_view> words = split_words(lines.line());
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "format") {
      header.format = parse_format(words, place());
      has_format = true;
    } else if (words[0] == "element") {
      header.elements.push_back(parse_element(words, place()));
    } else if (words[0] == "property") {
      if (header.elements.empty()) throw InputError(place(), "this property stands before any element");
      header.elements.back().properties.push_back(parse_property(words, place()));
    } else if (words[0] == "end_header") {
      if (!has_format) throw InputError(place(), "the PLY header has no format line");
      header.data_start = lines.offset();
      check_counts(header, bytes, name);
      return header;
    } else {
      throw InputError(place(), fmt::format("unknown word \"{}\" in a PLY header", words[0].substr(0, 40)));
    }
  }
  throw InputError(place(), "the PLY header has no end_header line; is the file truncated?");
}

}  // namespace capcon
