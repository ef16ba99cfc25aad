// fascia view: opens the window.
#include <iostream>

#include "app/cli/command_line.h"
#include "app/cli/output_files.h"
#include "app/cli/usage_error.h"
#include "app/commands/command.h"
#include "app/session/open_input.h"
#include "app/window/window.h"
#include "base/interrupt.h"
#include "render/supersampler.h"
#include "sim/output/simulation_fields.h"
#include "sim/output/state_export.h"

namespace fascia {
namespace {

int open_window(const ViewOptions& options) {
  if (options.context != "auto" && options.context != "window")
    throw UsageError("--context " + options.context, "has no window",
                     "expected window, or fascia render for a picture without one");
  const std::vector<OutputFile> outputs{{"--export", options.export_path, state_endings},
                                        {"--stats", options.stats, {".json"}, OutputFile::Takes::all_but_foreign},
                                        {"--frame-log", options.frame_log, {".csv"}}};
  require_outputs(outputs);
  Opened opened = open_input(options, options.sets);
  require_outputs(outputs, input_files(opened.scene));
  Graphics graphics = open_graphics(options, true, options.width, options.height,
                                    workload_of(opened.scene, opened.model, options.static_equilibrium));
  Window window(graphics, options, std::move(opened));
  if (!options.quiet && !graphics.context->other_device.empty())
    std::cerr << "fascia: " << graphics.context->other_device << '\n';
  if (!options.quiet)
    for (const std::string& note : window.simulation().model.notes) std::cerr << "fascia: " << note << '\n';
  window.run();

  const Simulation& simulation = window.simulation();
  const State last = simulation.state();
  if (!options.export_path.empty())
    write_state(options.export_path, simulation.model, export_fields(simulation, last, options.export_path),
                window.stats().provenance);
  if (!options.stats.empty()) write_stats(options.stats, window.stats(), simulation, last);
  window.finish_video();
  return interrupted() ? exit_interrupted : exit_done;
}

void add_view_options(CLI::App& command, ViewOptions& options) {
  add_common(command, options);
  command
      .get_option("scene")  // not from standard input, since a window reads its scene again
      ->type_name("FILE")
      ->description("scene (.json), tetrahedral mesh, surface or replay (.fascia); default: the shipped liver");
  command.get_option("--steps")->description(
      "steps after which the window closes by itself; it then keeps no settings, no session and no recent files. "
      "Default: it stays open");
  command.get_option("--time")->description(
      "simulated seconds after which the window closes by itself, as with --steps");
  add_size(command, options.width, options.height);
  command
      .add_option("--samples", options.samples,
                  "samples per pixel; the window takes as many of them as the renderer has")
      ->check(CLI::Range(1, kMostSamples))
      ->default_str("4, on software renderers 1");
  add_quality(command, options);
  command
      .add_option("--export", options.export_path,
                  "the state when the window closes: .vtu, .csv, .msh, .obj or .inp; to standard output as CSV")
      ->type_name(std::string("FILE") + kOrDash);
  command.add_option("--stats", options.stats, "numbers about the run, when the window closes")
      ->type_name(std::string("FILE.json") + kOrDash);
  command.add_option("--measured", options.measured, "measured curves, which the plots draw dashed and a fit can meet")
      ->type_name("FILE.csv");
  command
      .add_option("--frame-log", options.frame_log,
                  "the time of every frame and of its parts, when the window closes; fascia bench window reads it")
      ->type_name("FILE.csv");
}

// Options before a command are those of the window, and would be ignored.
void refuse_options_before_command(const CLI::App& program, Invocation& invocation) {
  for (const CLI::Option* option : program.get_options())
    if (option->count() > 0)
      invocation.run = [given = option->get_name(), command = program.get_subcommands().front()->get_name()]() -> int {
        throw UsageError(given, "stands before the command " + command, "expected it after the command");
      };
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
    // The program's own callback runs last, after any command.
    app->callback([&program, &invocation, options] {
      if (invocation.run) {
        refuse_options_before_command(program, invocation);
        return;
      }
      refuse_mistyped_command(program, options->input);
      options->command_line = invocation.command_line;
      invocation.run = [options] { return open_window(*options); };
    });
  }
}

}  // namespace fascia
