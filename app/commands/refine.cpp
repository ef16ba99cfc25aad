// fascia refine: proposes elements, mesh, integrator, substeps and iterations for a wanted error in a wanted time.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <limits>

#include "app/cli/command_line.h"
#include "app/cli/usage_error.h"
#include "app/commands/command.h"
#include "app/refine/choice.h"
#include "app/refine/confirmed_plan.h"
#include "app/refine/plan_text.h"
#include "app/refine/trial_run.h"
#include "app/session/graphics.h"
#include "app/session/open_input.h"
#include "base/error.h"
#include "base/text.h"

namespace fascia {
namespace {

struct RefineOptions : CommonOptions {
  double error = 0.02;  // relative
  double frame_ms = 16;
};

/// A positive number that may end in one of the units, each with its factor.
std::optional<double> parsed(std::string_view text, const std::vector<std::pair<std::string_view, double>>& units) {
  double value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  if (problem != std::errc() || !(value > 0) || !std::isfinite(value)) return std::nullopt;
  for (const auto& [name, factor] : units)
    if (unit == name) return factor * value;
  return std::nullopt;
}

void add_quantity(CLI::App& command, const std::string& name, double& field, const std::string& type,
                  const std::string& usual, const std::vector<std::pair<std::string_view, double>>& units, double most,
                  const std::string& help) {
  command
      .add_option_function<std::string>(
          name,
          [&field, name, type, units, most](const std::string& text) {
            const std::optional<double> value = parsed(text, units);
            if (!value || *value >= most)
              throw CLI::ValidationError(name, "is " + text + (value ? ", all of the displacement or more" : "") +
                                                   "; expected a positive number, as in " + type);
            field = *value;
          },
          help)
      ->type_name(type)
      ->default_str(usual);
}

/// Bodies whose mesh is the same in every choice.
std::string note_of_kept(const Scene& scene) {
  std::vector<std::string> kept;
  for (const Body& body : scene.bodies)
    if (!body.resolution) kept.push_back(body.name);
  if (kept.empty() || !has_resolution(scene)) return "";
  return "without a resolution, with the mesh that they have: " + join(kept);
}

int run_refine(const RefineOptions& options) {
  for (const auto& [given, name] :
       {std::pair(options.static_equilibrium, "--static"), std::pair(options.reference, "--reference")})
    if (given) throw UsageError(name, "leaves nothing to choose: refine plans the steps of the GPU", "leave it out");
  const Opened opened = open_input(options, options.sets);
  const Graphics graphics =
      open_graphics(options, false, 16, 16, workload_of(opened.scene, opened.model, false, false));
  announce(options, graphics, opened.model.notes);
  const double step = opened.scene.solver.time_step;
  const long steps = options.steps  ? *options.steps
                     : options.time ? std::lround(*options.time / step)
                                    : std::max(1L, std::lround(std::min(opened.scene.duration, 0.5) / step));
  const auto say = [&](const std::string& line) {
    if (!options.quiet) std::cerr << "fascia: " << line << '\n';
  };
  const auto open = [&](const std::vector<std::string>& sets) {
    CommonOptions again = options;
    again.quiet = true;
    again.sets.insert(again.sets.end(), sets.begin(), sets.end());
    Opened chosen = open_input(again, again.sets);
    return OpenedScene{std::move(chosen.scene), std::move(chosen.model)};
  };
  const TrialRuns runs{opened.scene, open, *graphics.programs, steps, say};
  if (const std::string note = note_of_kept(opened.scene); !note.empty()) say(note);
  std::vector<Trial> trials = run_trials(runs);
  if (interrupted()) return exit_interrupted;
  const Plan plan = confirmed_plan(
      trials, options.error, options.frame_ms, {refinements_of(opened.scene), has_resolution(opened.scene)},
      [&](const Proposal& choice, const Trial* alike) { return run_trial(runs, choice, alike); });
  if (interrupted()) return exit_interrupted;
  const double finest = refinements_of(opened.scene).back();
  std::cout << plan_text(plan, opened.scene, {options.error, options.frame_ms, finest * finest * finest});
  const std::vector<std::optional<Proposal>> printed =
      plan.within ? std::vector{plan.within}
                  : std::vector{plan.exact ? plan.exact : plan.best, plan.fast ? plan.fast : plan.fastest};
  const bool all_measured =
      std::all_of(printed.begin(), printed.end(), [](const std::optional<Proposal>& p) { return !p || p->measured; });
  std::cout << "estimates from " << plural(static_cast<std::size_t>(steps), "step") << " on this machine, with "
            << (all_measured ? "the choice proposed; assumed: "
                             : "the substeps proposed; assumed: the error of the mesh falls with the square of the "
                               "edges, the time of a step grows with tets and what an iteration adds; ")
            << "the errors add up\n";
  return plan.within ? exit_done : exit_failed;
}

}  // namespace

void add_refine(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<RefineOptions>();
  CLI::App& command = *program.add_subcommand(
      "refine", "proposes elements, mesh, integrator and iterations for a wanted error in a wanted time");
  add_common(command, *options);
  for (const char* refused : {"--static", "--reference"}) command.get_option(refused)->group("");  // not in the help
  add_quantity(command, "--error", options->error, "2%", "2%", {{"%", 0.01}, {"", 1}}, 1,
               "wanted error of the displacements, relative");
  add_quantity(command, "--frame", options->frame_ms, "16ms", "16ms", {{"ms", 1}, {"s", 1000}, {"", 1}},
               std::numeric_limits<double>::infinity(), "time that a step may take");
  add_examples(command, {"fascia refine liver.json --error 2% --frame 16ms"}, "no choice has that error in that time");
  command.callback([&invocation, options] {
    options->command_line = invocation.command_line;
    invocation.run = [options] { return run_refine(*options); };
  });
}

}  // namespace fascia
