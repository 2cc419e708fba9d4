#include "cli/completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace capcon::cli {
namespace {

std::string last_word(const std::string& path) {
  return path.substr(path.rfind(' ') + 1);
}

/// Within single quotes of a shell.
std::string quoted(std::string text) {
  for (std::size_t at = text.find('\''); at != text.npos; at = text.find('\'', at + 4))
    text.replace(at, 1, "'\\''");
  return "'" + text + "'";
}

std::vector<std::string> words_of(const CommandRow& row) {
  std::vector<std::string> words;
  for (const CommandRow& command : row.commands) words.push_back(last_word(command.path));
  for (const OptionRow& option : row.options)
    words.insert(words.end(), option.names.begin(), option.names.end());
  return words;
}

/// Case patterns: "capcon study"|"capcon study direct", of all verbs.
std::string verb_patterns(const CommandRow& program, const char* separator) {
  std::vector<std::string> paths;
  for (const CommandRow* row : flattened(program)) {
    if (row != &program) paths.push_back('"' + row->path + '"');
  }
  return fmt::format("{}", fmt::join(paths, separator));
}

/// Calls write(patterns, choices) for every option whose values can be named; patterns are
/// "capcon render --sampler".
template <class Write>
void each_choice(const CommandRow& program, const char* separator, const Write& write) {
  for (const CommandRow* row : flattened(program)) {
    for (const OptionRow& option : row->options) {
      if (option.choices.empty()) continue;
      std::vector<std::string> patterns;
      for (const std::string& name : option.names)
        patterns.push_back(fmt::format("\"{} {}\"", row->path, name));
      write(fmt::format("{}", fmt::join(patterns, separator)), option.choices);
    }
  }
}

}  // namespace

std::string bash_completion(const CommandRow& program) {
  std::string text = fmt::format(
      "# bash completion of capcon, made by `capcon completion bash`\n"
      "_capcon() {{\n"
      "  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} verb=capcon words= "
      "i\n"
      "  COMPREPLY=()\n"
      "  for ((i = 1; i < COMP_CWORD; i++)); do\n"
      "    case \"$verb ${{COMP_WORDS[i]}}\" in\n"
      "      {}) verb=\"$verb ${{COMP_WORDS[i]}}\" ;;\n"
      "    esac\n"
      "  done\n"
      "  case \"$verb $previous\" in\n",
      verb_patterns(program, "|"));
  each_choice(program, "|", [&](const std::string& patterns, const std::vector<std::string>& choices) {
    text += fmt::format("    {}) COMPREPLY=($(compgen -W \"{}\" -- \"$current\")); return ;;\n", patterns,
                        fmt::join(choices, " "));
  });
  text += "  esac\n  case $verb in\n";
  for (const CommandRow* row : flattened(program))
    text += fmt::format("    \"{}\") words=\"{}\" ;;\n", row->path, fmt::join(words_of(*row), " "));
  return text +
         "  esac\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
         "}\n"
         "complete -o bashdefault -o default -F _capcon capcon\n";
}

std::string zsh_completion(const CommandRow& program) {
  std::string text = fmt::format(
      "#compdef capcon\n"
      "# zsh completion of capcon, made by `capcon completion zsh`\n"
      "_capcon() {{\n"
      "  local verb=capcon i\n"
      "  local -a commands options\n"
      "  for ((i = 2; i < CURRENT; i++)); do\n"
      "    case \"$verb $words[i]\" in\n"
      "      ({}) verb=\"$verb $words[i]\" ;;\n"
      "    esac\n"
      "  done\n"
      "  case \"$verb $words[CURRENT-1]\" in\n",
      verb_patterns(program, "|"));
  each_choice(program, "|", [&](const std::string& patterns, const std::vector<std::string>& choices) {
    text += fmt::format("    ({}) compadd -- {}; return ;;\n", patterns, fmt::join(choices, " "));
  });
  text += "  esac\n  case $verb in\n";
  const auto described = [](const std::string& name, const std::string& words) {
    return quoted(name + ":" + first_line(words));
  };
  for (const CommandRow* row : flattened(program)) {
    text += fmt::format("    (\"{}\")\n      commands=(", row->path);
    for (const CommandRow& command : row->commands)
      text += " " + described(last_word(command.path), command.text);
    text += ")\n      options=(";
    for (const OptionRow& option : row->options) {
      for (const std::string& name : option.names) text += " " + described(name, option.text);
    }
    text += ") ;;\n";
  }
  return text +
         "  esac\n"
         "  if [[ $words[CURRENT] == -* ]]; then\n"
         "    _describe -o option options\n"
         "  else\n"
         "    (( $#commands )) && _describe verb commands\n"
         "    _files\n"
         "  fi\n"
         "}\n"
         "_capcon \"$@\"\n";
}

std::string fish_completion(const CommandRow& program) {
  std::string text = fmt::format(
      "# fish completion of capcon, made by `capcon completion fish`\n"
      "function __capcon_verb\n"
      "  set -l verb capcon\n"
      "  for word in (commandline -opc)[2..-1]\n"
      "    switch \"$verb $word\"\n"
      "      case {}\n"
      "        set verb \"$verb $word\"\n"
      "    end\n"
      "  end\n"
      "  echo $verb\n"
      "end\n",
      verb_patterns(program, " "));
  for (const CommandRow* row : flattened(program)) {
    const std::string when = fmt::format("complete -c capcon -n 'test (__capcon_verb) = \"{}\"'", row->path);
    for (const CommandRow& command : row->commands)
      text +=
          fmt::format("{} -f -a {} -d {}\n", when, last_word(command.path), quoted(first_line(command.text)));
    for (const OptionRow& option : row->options) {
      text += when;
      for (const std::string& name : option.names)
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      if (!option.value.empty()) text += " -r";
      if (!option.choices.empty()) text += fmt::format(" -f -a '{}'", fmt::join(option.choices, " "));
      text += " -d " + quoted(first_line(option.text)) + "\n";
    }
  }
  return text;
}

}  // namespace capcon::cli
