// The options of fascia bench and of the four benches below it.
#include "app/cli/command_line.h"
#include "app/commands/command.h"

namespace fascia {
namespace {

void add_figures(CLI::App& bench, Invocation& invocation) {
  const auto options = std::make_shared<BenchOptions>();
  CLI::App& command = *bench.add_subcommand("figures", "the figures of the poster, and what colorings cost");
  command.add_option("--out", options->out, "folder for the files, made if missing")->type_name("DIR")->required();
  command.add_flag("--quick", options->quick,
                   "small meshes, few iterations: the same files in less time, the numbers worth little");
  add_size(command, options->width, options->height);
  add_graphics(command, *options);
  add_examples(command, {"fascia bench figures --quick --out figures"});
  command.callback([&invocation, options] { invocation.run = [options] { return command_bench_figures(*options); }; });
}

void add_accuracy(CLI::App& bench, Invocation& invocation) {
  struct Options : BenchOptions {
    bool fresh = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App& command =
      *bench.add_subcommand("accuracy", "error against iterations and time, for every method and acceleration");
  command
      .add_option("--out", options->out, "folder for the files, made if missing; what it holds is not measured again")
      ->type_name("DIR")
      ->required();
  command.add_flag("--quick", options->quick, "three small cases, for a first look");
  command.add_flag("--fresh", options->fresh, "measure again what the folder holds");
  add_graphics(command, *options);
  add_examples(command, {"fascia bench accuracy --quick --out accuracy"});
  command.callback([&invocation, options] {
    invocation.run = [options] { return command_bench_accuracy(*options, options->fresh); };
  });
}

void add_speed(CLI::App& bench, Invocation& invocation) {
  struct Options : BenchOptions {
    std::string against;
  };
  const auto options = std::make_shared<Options>();
  CLI::App& command =
      *bench.add_subcommand("speed", "what steps cost, from 500 to a million tets, for every method and acceleration");
  command.add_option("--out", options->out, "folder for the tables, made if missing")->type_name("DIR")->required();
  command.add_flag("--quick", options->quick, "small meshes, few pairs");
  command
      .add_option("--against", options->against,
                  "an earlier speed.csv: the ratios, and exit code 1 where something became slower beyond the noise")
      ->type_name("FILE.csv");
  add_size(command, options->width, options->height);
  add_graphics(command, *options);
  add_examples(command, {"fascia bench speed --out speed --against old/speed.csv"}, "something became slower");
  command.callback([&invocation, options] {
    invocation.run = [options] { return command_bench_speed(*options, options->against); };
  });
}

void add_skip(CLI::App& bench, Invocation& invocation) {
  const auto options = std::make_shared<BenchOptions>();
  CLI::App& command = *bench.add_subcommand(
      "skip", "what features cost: never had, switched off, on; exit code 1 if off costs anything");
  command.add_option("--out", options->out, "folder for the table, made if missing")->type_name("DIR")->required();
  command.add_flag("--quick", options->quick, "a small mesh, few repetitions");
  add_graphics(command, *options);
  add_examples(command, {"fascia bench skip --out skip"}, "a feature that is off costs something");
  command.callback([&invocation, options] { invocation.run = [options] { return command_bench_skip(*options); }; });
}

}  // namespace

void add_bench(CLI::App& program, Invocation& invocation) {
  CLI::App& bench = *program.add_subcommand("bench", "measurements as tables, charts and pictures");
  bench.require_subcommand(1);
  add_figures(bench, invocation);
  add_accuracy(bench, invocation);
  add_speed(bench, invocation);
  add_skip(bench, invocation);
}

}  // namespace fascia
