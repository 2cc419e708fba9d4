#include "cli/man_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/file.h"

namespace capcon::cli {
namespace {

/// What roff would take for its own.
std::string escaped(std::string_view text) {
  std::string result;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
    line_begins = c == '\n';
  }
  return result;
}

/// Indented lines are commands: as they are; an empty line ends a paragraph.
std::string paragraphs(const std::string& text) {
  std::string result;
  bool literal = false;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    const bool command = line.starts_with("  ");
    if (command != literal) result += command ? ".PP\n.nf\n" : ".fi\n";
    literal = command;
    result += line.empty() ? ".PP\n" : escaped(line) + "\n";
  }
  return result + (literal ? ".fi\n" : "");
}

std::string entry(const OptionRow& row, bool positional) {
  std::vector<std::string> names;
  for (const std::string& name : row.names) names.push_back(fmt::format("\\fB{}\\fR", escaped(name)));
  const std::string value =
      row.value.empty() || positional ? "" : fmt::format(" \\fI{}\\fR", escaped(row.value));
  std::string text = fmt::format(".TP\n{}{}\n{}", fmt::join(names, ", "), value, escaped(row.text));
  if (row.text.empty()) text += "\\&";
  if (!row.choices.empty())
    text += "\n.br\n" + escaped(fmt::format("One of {}.", fmt::join(row.choices, ", ")));
  if (!row.standard.empty()) text += "\n.br\n" + escaped(fmt::format("Default: {}.", row.standard));
  if (row.required) text += "\n.br\nRequired.";
  return text + "\n";
}

std::string section(const CommandRow& row) {
  std::string text = fmt::format(".SS {}\n{}", escaped(row.path), paragraphs(row.text));
  for (const OptionRow& positional : row.positionals) text += entry(positional, true);
  for (const OptionRow& option : row.options) text += entry(option, false);
  if (!row.footer.empty()) text += ".PP\n" + paragraphs(row.footer);
  return text;
}

}  // namespace

std::string man_page(const CommandRow& program) {
  std::string text = fmt::format(
      ".TH CAPCON 1 \"\" \"capcon {}\" \"User Commands\"\n.SH NAME\ncapcon \\- capacity\\-constrained point "
      "sets, and what they are worth in rendering integrals\n.SH SYNOPSIS\n.B capcon\n\\fIVERB\\fR "
      "[\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n",
      escaped(version()));
  text += paragraphs(program.text);
  for (const OptionRow& option : program.options) text += entry(option, false);
  text += ".SH VERBS\n";
  for (const CommandRow* row : flattened(program)) {
    if (row != &program) text += section(*row);
  }
  text +=
      ".SH ENVIRONMENT\n.TP\n.B CAPCON_DATA\nFolder of tiles, ensembles and scenes, in place of those that "
      "were installed.\n.TP\n.B CAPCON_THREADS\nThreads that are used; all processors where it is not set.\n"
      ".SH FILES\n.TP\n.I share/capcon\nTiles, ensembles and scenes, beside the folder of the program.\n.TP\n"
      ".I ~/.cache/capcon\nWhat can be made again: ensembles of other sizes, compiled kernels.\n";
  return text;
}

}  // namespace capcon::cli
