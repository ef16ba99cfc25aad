// The options of fascia info.
#include "app/cli/command_line.h"
#include "app/commands/command.h"

namespace fascia {

void add_info(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App& command =
      *program.add_subcommand("info", "mesh doctor: sizes, materials, defects; what made a file of fascia's");
  CLI::Option* scene = command
                           .add_option("scene", options->input,
                                       "scene (.json) or tetrahedral mesh; or a picture, video, replay or export; - is "
                                       "a scene on standard input")
                           ->type_name(std::string("FILE") + kOrDash);
  command.add_flag("--tissues", options->tissues, "list the tissue presets with their sources, instead")
      ->excludes(scene);
  command.add_option("--set", options->sets, "override a scene value")->type_name("KEY=VALUE")->allow_extra_args(false);
  add_examples(command,
               {"fascia info liver.msh", "fascia info beam.json --set solver.colors=5", "fascia info --tissues"});
  command.callback([&invocation, options] {
    if (options->input.empty() && !options->tissues) throw CLI::RequiredError("scene, or --tissues,");
    invocation.run = [options] { return command_info(*options); };
  });
}

}  // namespace fascia
