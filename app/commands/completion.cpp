// fascia completion and fascia man: both print text that is generated from the tables of the other commands.
#include <iostream>

#include "app/cli/command_line.h"
#include "app/cli/completion.h"
#include "app/cli/manual_page.h"
#include "app/commands/command.h"

namespace fascia {

void add_completion(CLI::App& program, Invocation& invocation) {
  const auto shell = std::make_shared<std::string>();
  CLI::App& command = *program.add_subcommand(
      "completion", "completion of commands, options, files and scene keys for a shell, on stdout");
  add_choice(command, "shell", *shell, {"bash", "zsh", "fish"}, "the shell it is for")->required();
  add_examples(command, {"source <(fascia completion bash)                              # now",
                         "fascia completion fish > ~/.config/fish/completions/fascia.fish  # always"});
  command.callback([&program, &invocation, shell] {
    invocation.run = [&program, shell] {
      const CommandEntry tree = describe(program);
      std::cout << (*shell == "bash"  ? bash_completion(tree)
                    : *shell == "zsh" ? zsh_completion(tree)
                                      : fish_completion(tree));
      return exit_done;
    };
  });
}

void add_man(CLI::App& program, Invocation& invocation) {
  CLI::App& command =
      *program.add_subcommand("man", "the manual page, on stdout; once fascia is installed: man fascia");
  add_examples(command, {"fascia man | man -l -"});
  command.callback([&program, &invocation] {
    invocation.run = [&program] {
      std::cout << manual_page(describe(program));
      return exit_done;
    };
  });
}

}  // namespace fascia
