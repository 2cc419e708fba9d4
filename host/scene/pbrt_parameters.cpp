#include "scene/pbrt_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/number_text.h"
#include "scene/suggestion.h"

namespace capcon {
namespace {

enum class ValueKind { numbers, integers, strings, booleans, spectrum };

struct ParameterType {
  std::string_view name;
  ValueKind kind;
  std::size_t group;  ///< the number of values is a multiple of it
};

constexpr ParameterType kTypes[] = {
    {"float", ValueKind::numbers, 1},     {"integer", ValueKind::integers, 1},
    {"bool", ValueKind::booleans, 1},     {"string", ValueKind::strings, 1},
    {"texture", ValueKind::strings, 1},   {"point", ValueKind::numbers, 3},
    {"point2", ValueKind::numbers, 2},    {"point3", ValueKind::numbers, 3},
    {"vector", ValueKind::numbers, 3},    {"vector2", ValueKind::numbers, 2},
    {"vector3", ValueKind::numbers, 3},   {"normal", ValueKind::numbers, 3},
    {"normal3", ValueKind::numbers, 3},   {"color", ValueKind::numbers, 3},
    {"rgb", ValueKind::numbers, 3},       {"xyz", ValueKind::numbers, 3},
    {"spectrum", ValueKind::spectrum, 1}, {"blackbody", ValueKind::numbers, 1},
};

const ParameterType& find_type(std::string_view name, const SourcePlace& place) {
  std::vector<std::string_view> names;
  for (const ParameterType& type : kTypes) {
    if (type.name == name) return type;
    names.push_back(type.name);
  }
  throw InputError(place, fmt::format("unknown parameter type \"{}\"{}", name, suggestion(name, names)));
}

double number_of(Tokenizer& tokens, const Token& token, const std::string& what) {
  double value = 0;
  const NumberText text =
      token.kind == TokenKind::word ? parse_number(token.text, value) : NumberText::malformed;
  if (text == NumberText::malformed) {
    throw InputError(tokens.place(token), fmt::format("{} wants a number here, not {}", what, shown(token)));
  }
  if (text == NumberText::not_finite) {
    throw InputError(tokens.place(token),
                     fmt::format("{} wants a finite number here, not {}", what, shown(token)));
  }
  return value;
}

bool boolean_of(Tokenizer& tokens, const Token& token, const std::string& what) {
  const bool text = token.kind == TokenKind::word || token.kind == TokenKind::string;
  if (text && token.text == "true") return true;
  if (text && token.text == "false") return false;
  throw InputError(tokens.place(token),
                   fmt::format("{} wants true or false here, not {}", what, shown(token)));
}

/// Calls read(token) for each value: one without brackets, or all up to the closing bracket.
template <typename Read>
void each_value(Tokenizer& tokens, const std::string& what, const Read& read) {
  Token token = tokens.next();
  if (token.kind != TokenKind::open) {
    if (token.kind == TokenKind::end) {
      throw InputError(tokens.place(token), what + " has no value: the file ends here");
    }
    return read(token);
  }
  const Token open = token;
  for (token = tokens.next(); token.kind != TokenKind::close; token = tokens.next()) {
    if (token.kind == TokenKind::end) {
      throw InputError(tokens.place(open),
                       "this [ is never closed; put a ] behind the last value of " + what);
    }
    read(token);
  }
}

Parameters::Value read_value(Tokenizer& tokens, ValueKind kind, const std::string& what) {
  std::vector<double> numbers;
  std::vector<std::string> strings;
  std::vector<bool> booleans;
  each_value(tokens, what, [&](const Token& token) {
    const bool string = token.kind == TokenKind::string;
    if (kind == ValueKind::booleans) {
      booleans.push_back(boolean_of(tokens, token, what));
    } else if (kind == ValueKind::strings ||
               (kind == ValueKind::spectrum && numbers.empty() && (string || !strings.empty()))) {
      if (!string) {
        throw InputError(tokens.place(token),
                         fmt::format("{} wants a quoted string here, not {}", what, shown(token)));
      }
      strings.push_back(unescaped(token));
    } else {
      const double value = number_of(tokens, token, what);
      if (kind == ValueKind::integers && (value != std::floor(value) || std::abs(value) > 0x1p53)) {
        throw InputError(tokens.place(token),
                         fmt::format("{} wants a whole number here, not {}", what, shown(token)));
      }
      numbers.push_back(value);
    }
  });
  if (kind == ValueKind::booleans) return booleans;
  if (kind == ValueKind::strings || !strings.empty()) return strings;
  return numbers;
}

}  // namespace

Parameters read_parameters(Tokenizer& tokens, const std::vector<std::string_view>& skip) {
  Parameters parameters;
  while (tokens.peek().kind == TokenKind::string) {
    const Token token = tokens.next();
    const SourcePlace place = tokens.place(token);
    const std::string_view text = token.text;
    const std::size_t type_start = text.find_first_not_of(" \t");
    const std::size_t type_end = std::min(text.find_first_of(" \t", type_start), text.size());
    const std::size_t name_start = text.find_first_not_of(" \t", type_end);
    if (type_start == text.npos || name_start == text.npos) {
      throw InputError(place, fmt::format("a parameter is written \"type name\", not {}", shown(token)));
    }
    const std::size_t name_end = std::min(text.find_last_not_of(" \t") + 1, text.size());
    const ParameterType& type = find_type(text.substr(type_start, type_end - type_start), place);
    const std::string name(text.substr(name_start, name_end - name_start));
    const std::string what = fmt::format("\"{} {}\"", type.name, name);
    if (std::find(skip.begin(), skip.end(), name) != skip.end()) {
      each_value(tokens, what, [](const Token&) {});
      continue;
    }
    Parameters::Entry entry{std::string(type.name), read_value(tokens, type.kind, what), place};
    const auto* numbers = std::get_if<std::vector<double>>(&entry.value);
    if (numbers && numbers->size() % type.group != 0) {
      throw InputError(place, fmt::format("{} has {} numbers, which is not a multiple of {}", what,
                                          numbers->size(), type.group));
    }
    parameters.entries.emplace(name, std::move(entry));
  }
  return parameters;
}

std::string read_string(Tokenizer& tokens, const char* what) {
  const Token token = tokens.next();
  if (token.kind == TokenKind::string) return unescaped(token);
  throw InputError(tokens.place(token),
                   fmt::format("{} wants a quoted string here, not {}", what, shown(token)));
}

std::vector<double> read_numbers(Tokenizer& tokens, std::size_t count, const char* what) {
  std::vector<double> numbers;
  const bool bracketed = tokens.peek().kind == TokenKind::open;
  if (bracketed) tokens.next();
  while (numbers.size() < count) numbers.push_back(number_of(tokens, tokens.next(), what));
  if (bracketed) {
    const Token close = tokens.next();
    if (close.kind != TokenKind::close) {
      throw InputError(tokens.place(close),
                       fmt::format("{} wants {} numbers and then a ], not {}", what, count, shown(close)));
    }
  }
  return numbers;
}

}  // namespace capcon
