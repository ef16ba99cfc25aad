// fascia refine: proposes elements, mesh, integrator, substeps and iterations for a wanted error in a wanted time.
#include <charconv>
#include <cmath>
#include <iostream>

#include "app/cli/command_line.h"
#include "app/cli/usage_error.h"
#include "app/commands/command.h"
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
                  const std::string& usual, const std::vector<std::pair<std::string_view, double>>& units,
                  const std::string& help) {
  command
      .add_option_function<std::string>(
          name,
          [&field, name, type, units](const std::string& text) {
            const std::optional<double> value = parsed(text, units);
            if (!value) throw CLI::ValidationError(name, "is " + text + "; expected a positive number, as in " + type);
            field = *value;
          },
          help)
      ->type_name(type)
      ->default_str(usual);
}

std::string percent(double share) { return number(100 * share) + " %"; }

std::string describe(const Proposal& p, const Scene& scene) {
  const Body& body = scene.bodies.front();
  std::string text = "  " + std::to_string(std::lround(p.tets)) + ' ' + name_of(p.elements) + " tets (edges " +
                     number(1 / p.refinement) + " times as long), " + name_of(p.integrator) + ", " +
                     plural(static_cast<std::size_t>(p.substeps), "substep") + ", " +
                     plural(static_cast<std::size_t>(p.iterations), "iteration") + "\n  error " + percent(p.error()) +
                     ": mesh " + percent(p.mesh) + ", time " + percent(p.time) + ", solver " + percent(p.solver) +
                     "; " + number(p.ms) + " ms a step\n ";
  text += std::string(" --set elements=") + name_of(p.elements) + " --set solver.integrator=" + name_of(p.integrator) +
          " --set solver.substeps=" + std::to_string(p.substeps) +
          " --set solver.iterations=" + std::to_string(p.iterations);
  if (body.resolution)
    text += " --set resolution=" + std::to_string(std::lround(*body.resolution * p.refinement));
  else if (std::abs(p.refinement - 1) > 1e-9)
    text += "\n  and a mesh with that many tets";
  return text + '\n';
}

/// What is proposed, if no trial has its substeps.
std::optional<Proposal> unmeasured(const Plan& plan, const std::vector<Trial>& trials) {
  for (const std::optional<Proposal>& choice :
       {plan.within, plan.within ? std::nullopt : plan.exact, plan.within ? std::nullopt : plan.fast})
    if (choice && !measured(*choice, trials)) return choice;
  return std::nullopt;
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
  std::vector<Trial> trials = run_trials(opened.scene, *graphics.programs, steps, say);
  if (interrupted()) return exit_interrupted;
  Plan plan = plan_for(trials, options.error, options.frame_ms);
  // Errors of long steps do not yet follow the integrator's order.
  while (const std::optional<Proposal> choice = unmeasured(plan, trials)) {
    trials.push_back(run_trial(opened.scene, *graphics.programs, steps, *choice, say));
    if (interrupted()) return exit_interrupted;
    plan = plan_for(trials, options.error, options.frame_ms);
  }
  const std::string wanted = percent(options.error) + " in " + number(options.frame_ms) + " ms";
  if (plan.within) {
    std::cout << "for " << wanted << " a step:\n" << describe(*plan.within, opened.scene);
  } else {
    std::cout << "not within reach: " << wanted << " a step\n";
    if (plan.exact) std::cout << "for the error:\n" << describe(*plan.exact, opened.scene);
    if (plan.fast) std::cout << "for the time:\n" << describe(*plan.fast, opened.scene);
  }
  std::cout << "estimates from " << plural(static_cast<std::size_t>(steps), "step")
            << " on this machine, with the substeps proposed; assumed: the error of the mesh falls with the square of "
               "the edges, the time of a step grows with tets and what an iteration adds; the errors add up\n";
  return plan.within ? exit_done : exit_failed;
}

}  // namespace

void add_refine(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<RefineOptions>();
  CLI::App& command = *program.add_subcommand(
      "refine", "proposes elements, mesh, integrator and iterations for a wanted error in a wanted time");
  add_common(command, *options);
  add_quantity(command, "--error", options->error, "2%", "2%", {{"%", 0.01}, {"", 1}},
               "wanted error of the displacements, relative");
  add_quantity(command, "--frame", options->frame_ms, "16ms", "16ms", {{"ms", 1}, {"s", 1000}, {"", 1}},
               "time that a step may take");
  add_examples(command, {"fascia refine liver.json --error 2% --frame 16ms"}, "no choice has that error in that time");
  command.callback([&invocation, options] {
    options->command_line = invocation.command_line;
    invocation.run = [options] { return run_refine(*options); };
  });
}

}  // namespace fascia
