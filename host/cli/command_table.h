#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace capcon::cli {

/// An option or a positional of a verb, as its table declares it.
struct OptionRow {
  std::vector<std::string> names;    ///< "-o", "--output"; of a positional its one name
  std::string value;                 ///< what its value is called, "FILE"; empty for a flag
  std::vector<std::string> choices;  ///< the values there are, if they can be named
  std::string standard;              ///< the value where none is given; may be empty
  std::string text;
  bool required = false;
};

/// A verb, with those below it: what the man page and the shells' completions are made from.
struct CommandRow {
  std::string path;  ///< "capcon study direct"
  std::string text;  ///< what --help says of it, examples below an empty line
  std::string footer;
  std::vector<OptionRow> options, positionals;
  std::vector<CommandRow> commands;
};

/// All verbs of the program but hidden ones.
CommandRow command_table(const CLI::App& app);

/// The row itself and all below it, in order.
std::vector<const CommandRow*> flattened(const CommandRow& root);

/// Up to the first full line or `most` characters, for lists: "Render a scene to a float EXR".
std::string first_line(const std::string& text, std::size_t most = 70);

}  // namespace capcon::cli
