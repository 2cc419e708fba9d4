#include <fmt/format.h>

#include <memory>
#include <string>

#include "cli/completion.h"
#include "cli/man_page.h"
#include "cli/verbs.h"

namespace capcon::cli {

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
