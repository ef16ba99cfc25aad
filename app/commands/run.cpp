// fascia run: simulates without drawing; exports and stats.json.
#include <chrono>
#include <iostream>

#include "app/cli/command_line.h"
#include "app/cli/output_files.h"
#include "app/cli/usage_error.h"
#include "app/commands/command.h"
#include "app/session/graphics.h"
#include "app/session/open_input.h"
#include "app/session/progress_lines.h"
#include "base/error.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/provenance.h"
#include "base/text.h"
#include "sim/accuracy/mesh_error.h"
#include "sim/accuracy/nodal_stress.h"
#include "sim/accuracy/rigid_motions.h"
#include "sim/contact/tissue/penetration.h"
#include "sim/output/sample.h"
#include "sim/output/simulation_fields.h"
#include "sim/output/state_export.h"
#include "sim/output/stats.h"
#include "sim/reference/newton.h"
#include "sim/simulation/divergence.h"
#include "sim/simulation/errors/mesh_error_in_motion.h"
#include "sim/simulation/errors/solver_error.h"
#include "sim/simulation/errors/time_error.h"
#include "sim/simulation/errors/true_error.h"
#include "sim/simulation/errors/worst_step.h"
#include "sim/simulation/simulation.h"

namespace fascia {
namespace {

struct RunOptions : CommonOptions {
  std::string export_path;  // .vtu, .csv, .msh, .obj, .inp
  long every = 0;           // 0: only at the end
  std::string history;      // a CSV row every history_every-th step
  long history_every = 1;
  std::optional<std::uint32_t> probe;  // vertex of the history's displacement; none: the one farthest from the supports
  std::string stats;                   // stats.json
  bool error = false;                  // of the last step, against the exact one
  bool recovered_stress = false;       // its peaks, in the history and of the last state
  bool hash = false;                   // of the last state
};

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void require_finite(const State& state, const Scene& scene) {
  for (std::size_t i = 0; i < state.displacement.size(); ++i)
    if (!state.displacement[i].allFinite() || !state.velocity[i].allFinite())
      throw Error(scene.file.string(),
                  "vertex " + std::to_string(i) + " is not finite at " + std::to_string(state.time) + " s",
                  "expected finite positions: more substeps, softer material or a smaller load may help");
}

// The samples of --history: collected during the steps, written at the end, also after a failure.
class HistoryFile {
 public:
  HistoryFile(const RunOptions& options, const std::string& renderer, Simulation& simulation)
      : options_(options),
        renderer_(renderer),
        simulation_(simulation),
        probe_(options.probe ? *options.probe : tip_vertex(simulation.model)) {
    const std::size_t vertices = simulation.model.rest_positions.size();
    if (probe_ >= vertices)
      throw Error("--probe " + std::to_string(probe_), "is not a vertex of this scene",
                  "expected an index below " + std::to_string(vertices));
  }
  void add(double step_ms = Sample::kUnknown) {
    if (simulation_.steps_made() % options_.history_every != 0) return;
    samples_.push_back(sample_now(simulation_, probe_));
    samples_.back().step_ms = step_ms;
    if (options_.recovered_stress) measure_recovered(samples_.back(), simulation_);
  }
  void write() const {
    write_samples(options_.history, samples_, simulation_.model,
                  provenance_of(simulation_.scene, simulation_.model, renderer_, options_.command_line,
                                simulation_.steps_made(), simulation_.time()),
                  probe_);
  }

 private:
  const RunOptions& options_;
  const std::string& renderer_;
  Simulation& simulation_;
  std::uint32_t probe_;
  std::vector<Sample> samples_;
};

// An equilibrium has no error in time, and neither it nor a step of the reference solver one of the solver.
void measure_errors(const RunOptions& options, Simulation& simulation, const State& last, const PeakStress& peak,
                    WorstStep& worst, RunStats& stats) {
  const auto say = [&](const std::string& line) {
    if (!options.quiet) std::cerr << "fascia: " << line << '\n';
  };
  const auto percent = [](double share) { return number(100 * share) + " %"; };
  Errors errors;
  if (!options.static_equilibrium && !options.reference) {
    TrueError measured;
    const StepError& error = measured.measure(simulation);
    stats.error = error.relative;
    worst.add(error, simulation.time());
    errors.solver_step = worst.of_displacement();
    errors.solver_time = worst.time();
    errors.solver_steps = worst.compared();
    errors.solver = errors.solver_step;
    errors.peak_stress.solver = error.peak_stress.solver;
    if (const RunError passed_on = estimate_solver_error(simulation, simulation.programs()); passed_on.complete) {
      errors.solver_over_run = passed_on.over_run;
      errors.solver = std::max(*errors.solver, passed_on.relative);
      errors.peak_stress.solver = std::max(*errors.peak_stress.solver, passed_on.peak_stress);
    }
    say("true error of the last step " + percent(error.relative) + ", largest " + number(error.largest) + " m" +
        (error.converged ? "" : " (the reference solver did not converge)"));
    say("largest error of the solver in " + plural(static_cast<std::size_t>(worst.compared()), "step") +
        " compared: " + percent(errors.solver_step) + " of the displacement, at " + number(worst.time()) + " s" +
        (simulation.model.tets.size() > WorstStep::kMostTets ? " (of so many tets only the last step is compared)"
                                                             : ""));
  }
  if (!options.static_equilibrium) {
    const TimeError error = estimate_time_error(simulation, simulation.programs());
    if (error.complete) errors.time = error;
  }
  const MeshError mesh = estimate_mesh_error(simulation.model, last);
  errors.mesh_state = errors.mesh = mesh.displacement;
  errors.peak_stress.mesh = mesh.peak_stress;
  bool by_finer_tets = false;
  if (options.static_equilibrium) {
    const RunError at_rest = estimate_mesh_error_at_rest(simulation, simulation.programs());
    by_finer_tets = at_rest.complete;
    if (at_rest.complete) {
      errors.mesh = at_rest.relative;
      errors.peak_stress.mesh = std::max(errors.peak_stress.mesh, at_rest.peak_stress);
    }
  } else {
    const RunError passed_on = estimate_mesh_error_in_motion(simulation, simulation.programs());
    if (passed_on.complete) {
      errors.mesh_over_run = passed_on.over_run;
      // The way of a body that nothing holds hides how its shape is off.
      const bool held = free_pieces(simulation.model.tets, simulation.model.held()).empty();
      errors.mesh = held ? passed_on.relative : std::max(errors.mesh, passed_on.relative);
      errors.peak_stress.mesh = std::max(errors.peak_stress.mesh, passed_on.peak_stress);
    }
  }
  errors.peak_recovered = peak.p99;
  errors.peak_of_tets = mesh.peak_of_tets;
  const auto causes = [&](const std::optional<double>& solver, const std::optional<double>& time, double of_mesh) {
    return (solver ? "solver " + percent(*solver) + ", " : "") + (time ? "time " + percent(*time) + ", " : "") +
           "mesh " + percent(of_mesh);
  };
  const auto in_time = [&](double TimeError::*value) {
    return errors.time ? std::optional((*errors.time).*value) : std::nullopt;
  };
  say("of the displacement: " + causes(errors.solver, in_time(&TimeError::relative), errors.mesh) +
      "; of the peak stress: " +
      causes(errors.peak_stress.solver, in_time(&TimeError::peak_stress), errors.peak_stress.mesh) + " (estimates)");
  if (errors.solver_over_run)
    say("of the solver over the whole run: " + percent(*errors.solver_over_run) +
        ", against the same run with steps that are solved");
  if (errors.time)
    say("in time over the whole run: " + percent(errors.time->over_run) +
        (errors.time->resolved ? ", falling with the length of steps to the power " + number(errors.time->order)
                               : "; the motion is not resolved in time: errors hardly fall with eight times the "
                                 "substeps, and those in time are rough bounds"));
  if (errors.mesh_over_run)
    say("of the mesh over the whole run: " + percent(*errors.mesh_over_run) +
        ", against the same run on finer tets; of its last state alone: " + percent(errors.mesh_state));
  if (options.static_equilibrium && by_finer_tets)
    say("of the mesh against the equilibrium on finer tets; of this state alone: " + percent(errors.mesh_state));
  else if (options.static_equilibrium)
    say("of the mesh by this state alone, which hands and large turns mislead: nothing holds a body, its tets are too "
        "many, or the finer ones have no equilibrium");
  say("von Mises stress that 1 % of the volume exceeds: " + number(errors.peak_recovered) + " Pa recovered, " +
      number(mesh.peak_of_tets) + " Pa in the tets");
  stats.errors = errors;
}

std::vector<OutputFile> outputs_of(const RunOptions& options) {
  const bool has_file_beside = options.every == 0 && lower_ending(options.export_path) == ".csv";
  return {{"--export", options.export_path, state_endings},
          {"what made --export", has_file_beside ? provenance_beside(options.export_path).string() : "", {}},
          {"--history", options.history, {".csv"}, OutputFile::Takes::all_but_foreign},
          {"--stats", options.stats, {".json"}, OutputFile::Takes::all_but_foreign}};
}

void require_free_standard_output(const RunOptions& options) {
  const auto is_it = [](const std::string& path) { return path == kStandardOutput; };
  if (options.every > 0 && is_it(options.export_path))
    throw UsageError("--export -", "is one file, and --every writes many", "expected a file name, or no --every");
  if (options.hash && (is_it(options.export_path) || is_it(options.history) || is_it(options.stats)))
    throw UsageError("--hash", "prints on standard output, which another option writes",
                     "expected a file name instead of -");
}

int run_input(const RunOptions& options) {
  if (options.every > 0 && (options.export_path.empty() || options.static_equilibrium))
    throw UsageError("--every",
                     options.export_path.empty() ? "exports nothing" : "has no steps to export with --static",
                     options.export_path.empty() ? "expected --export FILE beside it" : "leave out one of them");
  if (!options.history.empty() && options.static_equilibrium)
    throw UsageError("--history", "has no steps to follow with --static", "leave out one of them");
  require_steps_or_static(options);
  require_free_standard_output(options);
  const std::vector<OutputFile> outputs = outputs_of(options);
  require_outputs(outputs);
  std::optional<EndAtOnce> opening(std::in_place);
  Opened opened = open_input(options, options.sets);
  require_outputs(outputs, input_files(opened.scene));
  Graphics graphics;
  if (!options.reference)
    graphics = open_graphics(options, false, 16, 16,
                             workload_of(opened.scene, opened.model, options.static_equilibrium, false));
  Simulation simulation(std::move(opened.scene), std::move(opened.model), graphics.programs.get(), options.reference);
  opening.reset();
  if (opened.replay) simulation.play(std::move(*opened.replay));
  if (options.error && !options.reference) simulation.gpu()->solve_everything();
  announce(options, graphics, simulation.model.notes);

  RunStats stats;
  stats.renderer = options.reference ? "reference solver, double precision" : describe(graphics);
  std::optional<StateSeries> series;
  const auto made_by = [&] {
    return provenance_of(simulation.scene, simulation.model, stats.renderer, options.command_line, stats.steps,
                         simulation.time());
  };
  if (options.every > 0 && !options.export_path.empty()) series.emplace(options.export_path);
  const auto export_frame = [&] {
    const State state = simulation.state();
    require_finite(state, simulation.scene);
    series->write(state.time, simulation.model, export_fields(simulation, state, options.export_path), made_by());
  };

  std::optional<HistoryFile> history;
  if (!options.history.empty()) history.emplace(options, stats.renderer, simulation);

  const long steps = options.static_equilibrium ? 0 : steps_to_run(options, simulation);
  WorstStep worst(simulation.model.tets.size(), steps);
  const Clock::time_point start = Clock::now();
  if (options.static_equilibrium) {
    const StaticReport report = simulation.solve_static(static_news(options.quiet), interrupt_token());
    if (interrupted()) return exit_interrupted;
    require_equilibrium(simulation, report);
    stats.solve_ms.push_back(milliseconds_since(start));
    stats.step_ms = stats.solve_ms;
    stats.residual = report.relative_residual;
    stats.steps = 1;
    if (!options.quiet) std::cerr << "fascia: " << describe(report) << '\n';
  } else {
    const Progress progress = options.quiet ? Progress() : stepping_progress(simulation.scene.file);
    if (series) export_frame();
    if (history) history->add();
    for (long i = 0; i < steps && !interrupted(); ++i) {
      const Clock::time_point step_start = Clock::now();
      simulation.step();
      if (!options.reference) gl::Finish();
      if (simulation.diverged()) {
        if (history) history->write();
        require_valid(simulation);
      }
      stats.solve_ms.push_back(milliseconds_since(step_start));
      ++stats.steps;
      if (options.error && stats.steps < steps) worst.look(simulation);
      if (history) history->add(stats.solve_ms.back());
      if (series && stats.steps % options.every == 0) export_frame();
      stats.step_ms.push_back(milliseconds_since(step_start));
      report(progress, static_cast<double>(stats.steps) / static_cast<double>(steps), "Simulating");
    }
  }
  stats.wall_s = milliseconds_since(start) / 1000;
  if (history) history->write();
  if (!options.static_equilibrium) require_valid(simulation);

  const State last = simulation.state();
  int inverted = 0;
  if (GpuSolver* gpu = simulation.gpu()) {
    gpu->request_diagnostics();
    auto diagnostics = gpu->take_diagnostics(true);
    simulation.correct_contact(diagnostics);
    if (diagnostics) {
      inverted = diagnostics->inverted;
      stats.tool_loads = diagnostics->tool_loads;
      stats.pair_loads = diagnostics->pair_loads;
    }
    if (diagnostics && !options.static_equilibrium) {
      stats.residual = diagnostics->residual;
      double mass = 0;
      for (const double m : lumped_masses(simulation.model)) mass += m;
      double of_support = 0;
      for (const reference::Support& support :
           reference::support_forces(simulation.model, last, simulation.contact_forces()))
        of_support = std::max(of_support, support.force.norm());
      stats.imbalance = diagnostics->imbalance(mass * simulation.model.gravity, of_support);
    }
    count_work(stats, simulation);
  } else {
    if (!options.static_equilibrium) stats.residual = simulation.newton_report().relative_residual;
    inverted = reference::measure(simulation.model, last).inverted;
    stats.tool_loads = simulation.newton_tool_loads();
    stats.pair_loads = simulation.newton_pair_loads();
    stats.taken_back = simulation.taken_back();
  }
  if ((options.error || options.recovered_stress) && !interrupted()) {
    const PeakStress peak = peak_of(nodal_stress(simulation.model, last), simulation.model);
    if (options.error) measure_errors(options, simulation, last, peak, worst, stats);
    if (options.recovered_stress) {
      stats.recovered = peak;
      if (!options.quiet)
        std::cerr << "fascia: recovered von Mises stress: at most " << number(peak.max) << " Pa, above "
                  << number(peak.p99) << " Pa in 1 % of the volume\n";
    }
  }
  stats.provenance = made_by();
  if (!options.stats.empty()) write_stats(options.stats, stats, simulation, last);
  require_finite(last, simulation.scene);
  const std::uint64_t hash = state_hash(last);
  const bool overridden =
      !options.sets.empty() || !options.grabs.empty() || !options.instruments.empty() || options.reference;
  if (options.hash) std::cout << "state " << hash_text(hash) << '\n';
  if (const auto& replay = simulation.replay();
      replay && replay->hash && replay->steps == stats.steps && !options.quiet)
    std::cerr << "fascia: "
              << (hash == *replay->hash ? "the state is the recorded one to the bit\n"
                  : overridden          ? "the state differs from the recorded one: other values, grabs or solver\n"
                                        : "the state differs from the recorded one: another device, program or mesh\n");
  if (!series && !options.export_path.empty())
    write_state(options.export_path, simulation.model, export_fields(simulation, last, options.export_path),
                stats.provenance);
  if (inverted > 0 && !options.quiet)
    std::cerr << "fascia: " << inverted << " of " << plural(simulation.model.tets.size(), "tet")
              << (inverted == 1 ? " is" : " are") << " inside out at the end\n";
  if (simulation.model.touches_tissue() && !options.quiet)
    if (const std::size_t pairs = penetrating_triangles(simulation.model, last.displacement); pairs > 0)
      std::cerr << "fascia: " << plural(pairs, "pair") << " of surface triangles pass through each other at the end\n";
  if (!options.quiet && options.static_equilibrium)
    std::cerr << "fascia: solved in " << stats.wall_s << " s\n";
  else if (!options.quiet)
    std::cerr << "fascia: " << plural(static_cast<std::size_t>(stats.steps), "step") << ", "
              << static_cast<double>(stats.steps) * simulation.scene.solver.time_step << " s simulated in "
              << stats.wall_s << " s, median " << percentiles(stats.solve_ms).median << " ms a step\n";
  return interrupted() ? exit_interrupted : exit_done;
}

}  // namespace

void add_run(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App& command = *program.add_subcommand("run", "simulate and draw nothing");
  add_common(command, *options);
  command
      .add_option("--export", options->export_path,
                  "the state after the last step: .vtu, .csv, .msh, .obj or .inp; to standard output as CSV")
      ->type_name(std::string("FILE") + kOrDash);
  command.add_option("--every", options->every, "export the start and every K-th step as numbered files")
      ->type_name("K")
      ->check(at_least(1));
  auto* history =
      command.add_option("--history", options->history, "a row per step: energies, volume, forces, residual, times")
          ->type_name(std::string("FILE.csv") + kOrDash);
  command.add_option("--history-every", options->history_every, "a row every K-th step")
      ->type_name("K")
      ->check(at_least(1))
      ->needs(history)
      ->capture_default_str();
  command
      .add_option("--probe", options->probe,
                  "vertex whose displacement the history has; default: the one farthest from the supports")
      ->type_name("VERTEX")
      ->needs(history);
  command.add_option("--stats", options->stats, "numbers about the run")->type_name(std::string("FILE.json") + kOrDash);
  command.add_flag("--error", options->error,
                   "what the last state is off by: of the solver, of the time step, of the mesh");
  command.add_flag("--recovered-stress", options->recovered_stress,
                   "the largest recovered von Mises stress, and that which 1 % of the volume exceeds, in --history and "
                   "--stats");
  command.add_flag("--hash", options->hash, "print a fingerprint of the last state");
  add_examples(command,
               {"fascia run beam.json --export out.vtu --every 10",
                "fascia run liver.json --static --set materials.default.young_modulus=8000 --export hanging.csv",
                "fascia run beam.json --time 1 --stats stats.json --quiet",
                "generate_scene | fascia run - --quiet --stats - | jq .residual"});
  command.callback([&invocation, options] {
    options->command_line = invocation.command_line;
    invocation.run = [options] { return run_input(*options); };
  });
}

}  // namespace fascia
