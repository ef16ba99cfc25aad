// The options of fascia stress.
#include "app/cli/command_line.h"
#include "app/commands/command.h"

namespace fascia {

void add_stress(CLI::App& program, Invocation& invocation) {
  struct Options : BenchOptions {
    std::string only, model = name_of(Material().model);
  };
  const auto options = std::make_shared<Options>();
  options->width = 640;
  options->height = 360;
  std::vector<std::string> models;
  for (const MaterialModel m : material_models()) models.push_back(name_of(m));
  CLI::App& command =
      *program.add_subcommand("stress", "the torture table: what no pair of method and acceleration may break at");
  command
      .add_option("--out", options->out,
                  "folder for the table, its summary, and a replay and a picture of every failure")
      ->type_name("DIR")
      ->required();
  command.add_flag("--quick", options->quick, "small meshes");
  command
      .add_option("--only", options->only,
                  "cases whose group/case/method + acceleration has such a part; * and ? as in file names")
      ->type_name("PATTERN");
  add_choice(command, "--model", options->model, models, "material model of all bodies")->capture_default_str();
  add_size(command, options->width, options->height);
  add_graphics(command, *options);
  add_examples(command, {"fascia stress --quick --out stress", "fascia stress --only 'start/*two_level' --out stress"},
               "a case fails");
  command.callback([&invocation, options] {
    invocation.run = [options] {
      return command_stress(*options, options->only, *find_material_model(options->model));
    };
  });
}

}  // namespace fascia
