// fascia kernels: compiles what a window of a scene needs, for the driver's cache on disk.
#include "app/cli/command_line.h"
#include "app/commands/command.h"
#include "app/session/graphics.h"
#include "app/session/open_input.h"
#include "sim/output/sample.h"
#include "sim/simulation/simulation.h"

namespace fascia {
namespace {

// A step of all tets, and one of those that move while others rest: drivers compile a kernel when it first runs.
void step_both_ways(GpuSolver& solver) {
  solver.step();
  solver.run_partial_kernels();
}

int compile_kernels(const CommonOptions& options) {
  Opened opened = open_input(options, options.sets);
  const Graphics graphics =
      open_graphics(options, false, 16, 16, workload_of(opened.scene, opened.model, false, false));
  announce(options, graphics, {});
  Simulation simulation(std::move(opened.scene), std::move(opened.model), graphics.programs.get(), false);
  simulation.step();
  GpuSolver& solver = *simulation.gpu();
  step_both_ways(solver);
  solver.set_grab({{tip_vertex(simulation.model), {0, 0, 0}, 1}});
  step_both_ways(solver);
  return exit_done;
}

}  // namespace

void add_kernels(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<CommonOptions>();
  CLI::App& command = *program.add_subcommand(
      "kernels", "compiles the kernels of a scene, free and grabbed, so that the driver's cache on disk has them");
  command.add_option("scene", options->input, "scene (.json), tetrahedral mesh or surface; default: the shipped liver")
      ->type_name(std::string("FILE") + kOrDash);
  command.add_option("--set", options->sets, "override a scene value, e.g. solver.method=jacobi")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  add_graphics(command, *options);
  add_examples(command, {"fascia kernels liver.json --context egl  # a window then begins without compiling"});
  command.callback([&invocation, options] { invocation.run = [options] { return compile_kernels(*options); }; });
}

}  // namespace fascia
