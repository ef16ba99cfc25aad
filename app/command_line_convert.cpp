// The options of fascia convert.
#include "app/command_line.h"
#include "app/commands.h"

namespace fascia {

void add_convert(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App& command = *program.add_subcommand("convert", "between mesh formats, by the ending of OUT");
  command.add_option("in", options->in, "mesh to read")->type_name("FILE")->required();
  command.add_option("out", options->out, "mesh to write: .msh .vtk .vtu .node .mesh")->type_name("FILE")->required();
  command.add_flag("--weld", options->weld, "make vertices at exactly one place one: halves that only touch hold together");
  add_examples(command, {"fascia convert model.vtu model.msh"});
  command.callback([&invocation, options] { invocation.run = [options] { return command_convert(*options); }; });
}

}  // namespace fascia
