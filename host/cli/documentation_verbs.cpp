#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>

#include "cli/command_table.h"
#include "cli/completion.h"
#include "cli/man_page.h"
#include "cli/verbs.h"
#include "sampling/sampler.h"

namespace capcon::cli {
namespace {

std::vector<std::string> parted(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

OptionRow option_row(const CLI::Option& option) {
  OptionRow row;
  const bool positional = !option.nonpositional();
  row.names =
      positional ? std::vector<std::string>{option.get_name(true)} : parted(option.get_name(false, true));
  row.text = option.get_description();
  row.required = option.get_required();
  if (option.get_items_expected_max() == 0) return row;  // a flag
  row.standard = option.get_default_str();
  row.value = option.get_type_name();
  // CLI11 puts what its checks say behind the type: "TEXT:{ao,direct}", "UINT:INT in [1 - 4]".
  const std::size_t open = row.value.find('{'), close = row.value.rfind('}');
  if (open != std::string::npos && close != std::string::npos && open < close)
    row.choices = parted(row.value.substr(open + 1, close - open - 1));
  row.value = row.value.substr(0, row.value.find(':'));
  if (row.value.empty()) row.value = "VALUE";
  const auto is = [&](const char* name) {
    return std::find(row.names.begin(), row.names.end(), name) != row.names.end();
  };
  if (is("--sampler") || is("--path-sampler") || is("--samplers")) row.choices = sampler_names();
  return row;
}

CommandRow command_row(const CLI::App& app, const std::string& above) {
  CommandRow row;
  row.path = above.empty() ? app.get_name() : above + " " + app.get_name();
  row.text = app.get_description();
  row.footer = app.get_footer();
  for (const CLI::Option* option : app.get_options())
    (option->nonpositional() ? row.options : row.positionals).push_back(option_row(*option));
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (!command->get_group().empty()) row.commands.push_back(command_row(*command, row.path));
  }
  return row;
}

}  // namespace

CommandRow command_table(const CLI::App& app) {
  return command_row(app, {});
}

std::vector<const CommandRow*> flattened(const CommandRow& root) {
  std::vector<const CommandRow*> all = {&root};
  for (const CommandRow& command : root.commands) {
    const std::vector<const CommandRow*> below = flattened(command);
    all.insert(all.end(), below.begin(), below.end());
  }
  return all;
}

std::string first_line(const std::string& text, std::size_t most) {
  std::string line = text.substr(0, text.find('\n'));
  if (line.size() <= most) return line;
  line.resize(std::min(line.rfind(' ', most), most));
  return line + " ...";
}

void add_documentation_verbs(CLI::App& app) {
  CLI::App* man = app.add_subcommand("man", "print the manual page: capcon man | man -l -");
  man->callback([&app] { fmt::print("{}", man_page(command_table(app))); });
  CLI::App* completion =
      app.add_subcommand("completion",
                         "print the script that completes verbs and options in a shell\n\n"
                         "  source <(capcon completion bash)\n"
                         "  capcon completion zsh > ~/.zfunc/_capcon\n"
                         "  capcon completion fish > ~/.config/fish/completions/capcon.fish\n");
  auto shell = std::make_shared<std::string>();
  completion->add_option("shell", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  completion->callback([&app, shell] {
    const CommandRow program = command_table(app);
    fmt::print("{}", *shell == "bash"  ? bash_completion(program)
                     : *shell == "zsh" ? zsh_completion(program)
                                       : fish_completion(program));
  });
}

}  // namespace capcon::cli
