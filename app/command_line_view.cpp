// The options of fascia view, which are also those of fascia without a command.
#include "app/command_line.h"
#include "app/commands.h"

namespace fascia {
namespace {

void add_view_options(CLI::App& command, ViewOptions& options) {
  add_common(command, options);
  add_size(command, options.width, options.height);
  command.add_option("--samples", options.samples, "samples per pixel")->check(CLI::Range(1, 16))->default_str("4, on software renderers 1");
  command.add_option("--export", options.export_path, "the state when the window closes: .vtu, .csv, .msh or .obj")->type_name("FILE");
  command.add_option("--stats", options.stats, "numbers about the run, when the window closes")->type_name("FILE.json");
}

}  // namespace

void add_view(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<ViewOptions>();
  CLI::App& command = *program.add_subcommand("view", "the window (the default command)");
  for (CLI::App* app : {&program, &command}) {
    add_view_options(*app, *options);
    // The program's own callback runs last, whatever the command was.
    app->callback([&invocation, options] {
      if (invocation.run) return;
      options->command_line = invocation.command_line;
      invocation.run = [options] { return command_view(*options); };
    });
  }
}

}  // namespace fascia
