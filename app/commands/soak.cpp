// fascia soak: long runs that reveal drift and leaks.
#include "app/stress/soak.h"
#include "app/bench/bench.h"
#include "app/cli/command_line.h"
#include "app/commands/command.h"
#include "app/system/paths.h"

namespace fascia {
namespace {

struct SoakOptions : BenchOptions {
  std::vector<std::string> scenes;
  long step_count = 100000;
  Discretization discretization;
};

int run_soak(const SoakOptions& options) {
  Bench bench(options, "soak");
  try {
    bench.say(describe(bench.graphics));
    std::vector<std::filesystem::path> inputs;
    for (const std::string& name : options.scenes) inputs.push_back(input_or_shipped(name, options.data_dir));
    if (inputs.empty())
      for (const char* name : {"cube.json", "inclusion.json", "beam.json"})
        inputs.push_back(default_scene(bench.graphics.data_dir).parent_path() / name);
    return soak_scenes(bench, inputs, options.step_count, options.discretization) > 0 ? exit_failed : exit_done;
  } catch (const Interrupted&) {
    return exit_interrupted;
  }
}

}  // namespace

void add_soak(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<SoakOptions>();
  CLI::App& command = *program.add_subcommand(
      "soak", "scenes that are grabbed and let go for very long, twice: what drifts, what grows");
  command.add_option("scenes", options->scenes, "scenes (.json) or tetrahedral meshes; default: three shipped ones")
      ->type_name("FILE");
  command.add_option("--out", options->out, "folder for the table")->type_name("DIR")->required();
  command.add_option("--steps", options->step_count, "of every run")
      ->check(CLI::Range(2400l, 1000000000l))
      ->capture_default_str();
  add_discretization(command, options->discretization, "of all scenes; default: their own");
  add_graphics(command, *options);
  add_examples(command, {"fascia soak cube.json --steps 20000 --out soak"}, "something drifts or grows");
  command.callback([&invocation, options] { invocation.run = [options] { return run_soak(*options); }; });
}

}  // namespace fascia
