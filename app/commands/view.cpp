// fascia view: the window.
#include <iostream>

#include "app/cli/output_files.h"
#include "app/cli/usage_error.h"
#include "app/commands/command.h"
#include "app/session/open_input.h"
#include "app/window/window.h"
#include "base/interrupt.h"
#include "sim/output/state_export.h"
#include "sim/reference/newton.h"

namespace fascia {

int command_view(const ViewOptions& options) {
  if (options.context != "auto" && options.context != "window")
    throw UsageError("--context " + options.context, "has no window",
                     "expected window, or fascia render for a picture without one");
  const std::vector<OutputFile> outputs{{"--export", options.export_path, state_endings},
                                        {"--stats", options.stats, {".json"}, OutputFile::Takes::all_but_foreign}};
  require_outputs(outputs);
  Opened opened = open_input(options, options.sets);
  require_outputs(outputs, input_files(opened.scene));
  Graphics graphics = open_graphics(options, true, options.width, options.height,
                                    workload_of(opened.scene, opened.model, options.static_equilibrium));
  Window window(graphics, options, std::move(opened));
  if (!options.quiet)
    for (const std::string& note : window.simulation().model.notes) std::cerr << "fascia: " << note << '\n';
  window.run();

  const Simulation& simulation = window.simulation();
  const State last = simulation.state();
  if (!options.export_path.empty())
    write_state(options.export_path, simulation.model.file_mesh, reference::export_fields(simulation.model, last),
                window.stats().provenance);
  if (!options.stats.empty()) write_stats(options.stats, window.stats(), simulation, last);
  window.finish_video();
  return interrupted() ? exit_interrupted : exit_done;
}

}  // namespace fascia
