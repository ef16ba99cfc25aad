// fascia kernels: compiles what a window of a scene needs, for the driver's cache on disk.
#include "app/cli/command_line.h"
#include "app/commands/command.h"
#include "app/session/graphics.h"
#include "app/session/open_input.h"
#include "sim/output/sample.h"
#include "sim/simulation/simulation.h"

namespace fascia {
namespace {

struct KernelOptions : CommonOptions {
  bool whole_steps = false;
};

// Drivers compile a kernel when it first runs. Steps of all tets come first, since every window makes them, with
// contact and without in scenes with tools; then those of tets that move while others rest.
int compile_kernels(const KernelOptions& options) {
  Opened opened = open_input(options, options.sets);
  const Graphics graphics =
      open_graphics(options, false, 16, 16, workload_of(opened.scene, opened.model, false, false));
  announce(options, graphics, {});
  Simulation simulation(std::move(opened.scene), std::move(opened.model), graphics.programs.get(), false);
  simulation.step();
  GpuSolver& solver = *simulation.gpu();
  solver.step();
  solver.run_contact_kernels();
  solver.set_grab({{tip_vertex(simulation.model), {0, 0, 0}, 1}});
  solver.step();
  solver.run_contact_kernels();
  if (options.whole_steps) return exit_done;
  solver.run_partial_kernels();
  solver.set_grab({});
  solver.run_partial_kernels();
  return exit_done;
}

}  // namespace

void add_kernels(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<KernelOptions>();
  CLI::App& command = *program.add_subcommand(
      "kernels", "compiles the kernels of a scene, free and grabbed, so that the driver's cache on disk has them");
  command.add_option("scene", options->input, "scene (.json), tetrahedral mesh or surface; default: the shipped liver")
      ->type_name(std::string("FILE") + kOrDash);
  command.add_option("--set", options->sets, "override a scene value, e.g. solver.method=jacobi")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_flag("--whole-steps", options->whole_steps,
                   "only steps of all tets, not those of a part while others rest");
  add_graphics(command, *options);
  add_examples(command, {"fascia kernels liver.json --context egl  # a window then begins without compiling"});
  command.callback([&invocation, options] { invocation.run = [options] { return compile_kernels(*options); }; });
}

}  // namespace fascia
