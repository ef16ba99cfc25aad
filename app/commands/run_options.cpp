// The options of fascia run.
#include "app/cli/command_line.h"
#include "app/commands/command.h"

namespace fascia {

void add_run(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App& command = *program.add_subcommand("run", "simulate and draw nothing");
  add_common(command, *options);
  command
      .add_option("--export", options->export_path,
                  "the state after the last step: .vtu, .csv, .msh or .obj; to standard output as CSV")
      ->type_name(std::string("FILE") + kOrDash);
  command.add_option("--every", options->every, "export every K-th step as numbered files")
      ->type_name("K")
      ->check(at_least(1));
  auto* history =
      command.add_option("--history", options->history, "a row per step: energies, volume, forces, residual, times")
          ->type_name(std::string("FILE.csv") + kOrDash);
  command.add_option("--history-every", options->history_every, "a row every K-th step")
      ->type_name("K")
      ->check(at_least(1))
      ->needs(history)
      ->capture_default_str();
  command
      .add_option("--probe", options->probe,
                  "vertex whose displacement the history has; default: the one farthest from the supports")
      ->type_name("VERTEX")
      ->needs(history);
  command.add_option("--stats", options->stats, "numbers about the run")->type_name(std::string("FILE.json") + kOrDash);
  command.add_flag("--error", options->error, "compare the last step with the exact one, by the reference solver");
  command.add_flag("--hash", options->hash, "print a fingerprint of the last state");
  add_examples(command,
               {"fascia run beam.json --export out.vtu --every 10",
                "fascia run liver.json --static --set materials.default.young_modulus=8000 --export hanging.csv",
                "fascia run beam.json --time 1 --stats stats.json --quiet",
                "generate_scene | fascia run - --quiet --stats - | jq .residual"});
  command.callback([&invocation, options] {
    options->command_line = invocation.command_line;
    invocation.run = [options] { return command_run(*options); };
  });
}

}  // namespace fascia
