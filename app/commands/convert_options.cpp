// The options of fascia convert.
#include "app/cli/command_line.h"
#include "app/commands/command.h"

namespace fascia {

void add_convert(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App& command = *program.add_subcommand(
      "convert", "between mesh formats, by the ending of OUT; a scene or a replay to one that carries its meshes");
  command.add_option("in", options->in, "mesh, scene or replay to read")->type_name("FILE")->required();
  command
      .add_option("out", options->out,
                  "mesh to write: .msh, .vtk, .vtu, .node, .ele or .mesh; with --with-mesh a scene (.json) or a replay "
                  "(.fascia)")
      ->type_name("FILE")
      ->required();
  CLI::Option* const weld = command.add_flag(
      "--weld", options->weld, "make vertices at exactly one place one: halves that only touch hold together");
  command
      .add_flag("--with-mesh", options->with_mesh,
                "OUT is the scene or the replay IN with all the files in it that it refers to: it opens anywhere")
      ->excludes(weld);
  add_examples(command, {"fascia convert model.vtu model.msh", "fascia convert liver.json elsewhere.json --with-mesh"});
  command.callback([&invocation, options] { invocation.run = [options] { return command_convert(*options); }; });
}

}  // namespace fascia
