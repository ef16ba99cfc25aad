// The options of fascia view, which are also those of fascia without a command.
#include <filesystem>

#include "app/command_line.h"
#include "app/commands.h"
#include "sim/suggest.h"

namespace fascia {
namespace {

void add_view_options(CLI::App& command, ViewOptions& options) {
  add_common(command, options);
  add_size(command, options.width, options.height);
  command.add_option("--samples", options.samples, "samples per pixel")->check(CLI::Range(1, 16))->default_str("4, on software renderers 1");
  command.add_option("--export", options.export_path, "the state when the window closes: .vtu, .csv, .msh or .obj")->type_name("FILE");
  command.add_option("--stats", options.stats, "numbers about the run, when the window closes")->type_name("FILE.json");
}

// "fascia rendr": a scene by that name, unless there is none and a command is called nearly so.
void refuse_mistyped_command(const CLI::App& program, const std::string& input) {
  std::error_code ec;
  if (input.empty() || input.find_first_of("./") != std::string::npos || std::filesystem::exists(input, ec)) return;
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) names.push_back(command->get_name());
  const std::string near = nearest(input, names);
  if (!near.empty()) throw CLI::ValidationError(input + ": neither a file nor a command; perhaps you meant " + near);
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
