// The options of fascia check.
#include "app/check/check.h"
#include "app/cli/command_line.h"
#include "app/commands/command.h"

namespace fascia {

void add_check(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App& command = *program.add_subcommand(
      "check", "a folder of scenes against golden pictures and states; exit code 1 where one differs");
  command.add_option("folder", options->folder, "scenes and replays, their goldens beside them, and check.json")
      ->type_name("DIR")
      ->required();
  command.add_flag("--update", options->update,
                   "write the goldens anew and say what changed: look at every picture before you keep it");
  command
      .add_option("--out", options->out, "folder for the new picture, the new state and the difference of what fails")
      ->type_name("DIR");
  command.add_option("--junit", options->junit, "the results for GitLab, Jenkins or GitHub")->type_name("FILE.xml");
  command.add_option("--only", options->only, "scenes whose name has such a part; * and ? as in file names")
      ->type_name("PATTERN");
  command.add_option("--timeout", options->timeout, "after which a scene counts as failed")
      ->type_name("SECONDS")
      ->check(CLI::Range(1e-3, 1e7))
      ->capture_default_str();
  add_graphics(command, *options);
  add_examples(
      command,
      {"fascia check assets/check", "fascia check tests/scenes --context osmesa --junit report.xml --out failures",
       "fascia check tests/scenes --only liver --update"},
      "a scene differs or could not be checked");
  command.callback([&invocation, options] {
    options->command_line = invocation.command_line;
    invocation.run = [options] { return command_check(*options); };
  });
}

}  // namespace fascia
