#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/pbrt_tokens.h"
#include "scene/scene.h"

namespace capcon {

/// Reads `"type name" values` pairs up to the next directive. A parameter given twice keeps its first value,
/// as in pbrt. Those named in `skip` are passed over without reading their values. InputError with its place
/// for an unknown type, a value of the wrong type, a wrong number of values.
Parameters read_parameters(Tokenizer& tokens, const std::vector<std::string_view>& skip = {});

/// The quoted string that a directive wants next.
std::string read_string(Tokenizer& tokens, const char* what);
/// Exactly `count` numbers, in brackets or not.
std::vector<double> read_numbers(Tokenizer& tokens, std::size_t count, const char* what);

}  // namespace capcon
