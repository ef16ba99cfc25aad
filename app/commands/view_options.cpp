// The options of fascia view, which are also those of fascia without a command.
#include "app/cli/command_line.h"
#include "app/commands/command.h"
#include "render/supersampler.h"

namespace fascia {
namespace {

void add_view_options(CLI::App& command, ViewOptions& options) {
  add_common(command, options);
  command
      .get_option("scene")  // not from standard input: a window reads its scene again
      ->type_name("FILE")
      ->description("scene (.json), tetrahedral mesh, surface (.obj) or replay (.fascia); default: the shipped liver");
  command.get_option("--steps")->description(
      "steps after which the window closes by itself; it then keeps no settings, no session and no recent files. "
      "Default: it stays open");
  command.get_option("--time")->description(
      "simulated seconds after which the window closes by itself, as with --steps");
  add_size(command, options.width, options.height);
  command
      .add_option("--samples", options.samples,
                  "samples per pixel; the window takes as many of them as the renderer has")
      ->check(CLI::Range(1, kMostSamples))
      ->default_str("4, on software renderers 1");
  command
      .add_option("--export", options.export_path,
                  "the state when the window closes: .vtu, .csv, .msh or .obj; to standard output as CSV")
      ->type_name(std::string("FILE") + kOrDash);
  command.add_option("--stats", options.stats, "numbers about the run, when the window closes")
      ->type_name(std::string("FILE.json") + kOrDash);
}

}  // namespace

void add_view(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<ViewOptions>();
  CLI::App& command = *program.add_subcommand("view", "the window (the default command)");
  for (CLI::App* app : {&program, &command}) {
    add_view_options(*app, *options);
    add_examples(*app, {"fascia                                  # the window on the default scene",
                        "fascia liver.json --set solver.iterations=20",
                        "fascia render liver.json --out shot.png  # fascia COMMAND --help says more"});
    // The program's own callback runs last, whatever the command was.
    app->callback([&program, &invocation, options] {
      if (invocation.run) return;
      refuse_mistyped_command(program, options->input);
      options->command_line = invocation.command_line;
      invocation.run = [options] { return command_view(*options); };
    });
  }
}

}  // namespace fascia
