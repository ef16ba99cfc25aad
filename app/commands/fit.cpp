// fascia fit: finds the parameters with which a scene's simulation meets a measurement, and how sure they are.
#include <charconv>
#include <chrono>
#include <cmath>
#include <iostream>

#include "app/cli/command_line.h"
#include "app/cli/usage_error.h"
#include "app/commands/command.h"
#include "app/fit/fit_progress.h"
#include "app/fit/fit_report.h"
#include "app/fit/fit_text.h"
#include "app/session/graphics.h"
#include "app/session/open_input.h"
#include "base/error.h"
#include "base/file.h"
#include "base/suggest.h"
#include "base/text.h"
#include "sim/fit/fit.h"
#include "sim/fit/gpu/gpu_simulator.h"
#include "sim/fit/simulated/reference_simulator.h"
#include "sim/output/sample.h"
#include "sim/reference/newton.h"
#include "sim/scene/scene_carry.h"

namespace fascia {
namespace {

struct FitCommandOptions : CommonOptions {
  std::vector<std::string> measured, free, bounds, priors, noise, columns;
  std::optional<std::uint32_t> probe;
  std::string out;
  int sweep = 0, profile = 3;
  bool gpu = false;
};

std::optional<double> positive(std::string_view text) {
  double value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = problem == std::errc() && end == text.data() + text.size();
  return whole && value > 0 && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

// "1%", "0.02N", "0.1mm".
Noise noise_of(const std::string& text) {
  const std::size_t begin = std::min(text.find_first_not_of("0123456789.+-eE"), text.size());
  const std::optional<double> value = positive(std::string_view(text).substr(0, begin));
  const std::string name = text.substr(begin);
  const Unit* unit = find_unit(name);
  const bool known = name == "%" || (unit && unit->dimension != Dimension::time);
  if (!value || !known)
    throw UsageError("--noise " + text, "is no noise", "expected a share or an amount, as in 1%, 0.02N or 0.1mm");
  if (name == "%") return {*value / 100, true, Dimension::force};
  return {*value * unit->size, false, unit->dimension};
}

std::vector<Measurement> measurements_of(const FitCommandOptions& options, const Model& model) {
  MeasurementRead how{options.probe.value_or(0), {}, options.columns};
  if (!options.probe) how.probe = tip_vertex(model);
  if (how.probe >= model.rest_positions.size())
    throw UsageError("--probe " + std::to_string(how.probe), "is not a vertex of this scene",
                     "expected an index below " + std::to_string(model.rest_positions.size()));
  for (const Column& column : sample_columns()) how.passed_over.push_back(column.name);
  std::vector<Measurement> measurements;
  for (const std::string& text : options.measured) {
    const std::size_t comma = std::min(text.rfind(','), text.size());
    const std::optional<double> weight =
        comma < text.size() ? positive(std::string_view(text).substr(comma + 1)) : std::nullopt;
    measurements.push_back(read_measurement(weight ? text.substr(0, comma) : text, model, how));
    measurements.back().weight = weight.value_or(1);
    for (const std::string& note : measurements.back().notes)
      if (!options.quiet) std::cerr << "fascia: " << measurements.back().file.string() << ": " << note << '\n';
  }
  std::vector<Noise> noise;
  for (const std::string& entry : options.noise) noise.push_back(noise_of(entry));
  assign_noise(measurements, noise, model);
  return measurements;
}

// What leads a fit beside its scene and measurements, as text.
std::string path_options(const FitCommandOptions& options, double end) {
  std::vector<std::string> all{options.static_equilibrium ? "static" : "motion", options.gpu ? "gpu" : "reference",
                               number(end), std::to_string(options.sweep),
                               options.probe ? std::to_string(*options.probe) : "tip"};
  for (const auto* list :
       {&options.measured, &options.free, &options.bounds, &options.priors, &options.noise, &options.columns}) {
    all.emplace_back("");
    all.insert(all.end(), list->begin(), list->end());
  }
  return join(all);
}

// `graphics`: opened where the GPU simulates.
std::unique_ptr<Simulator> simulator_of(const FitCommandOptions& options, const Opened& opened, Graphics& graphics) {
  if (!options.gpu) {
    if (opened.model.tets.size() > reference::NewtonSolver::kMostTets && !options.quiet)
      std::cerr << "fascia: " << opened.scene.file.string() << ": " << opened.model.tets.size()
                << " tets take the reference solver long; --gpu simulates on the GPU\n";
    return std::make_unique<ReferenceSimulator>(interrupt_token());
  }
  graphics =
      open_graphics(options, false, 16, 16, workload_of(opened.scene, opened.model, options.static_equilibrium, false));
  announce(options, graphics, {});
  return std::make_unique<GpuSimulator>(*graphics.programs, interrupt_token());
}

int run_fit(const FitCommandOptions& options) {
  if (!options.replay.empty()) throw UsageError("--replay", "cannot be fitted", "expected a scene");
  require_steps_or_static(options);
  if (!options.priors.empty() && options.noise.empty())
    throw UsageError("--prior", "is weighed against the noise of the measurement", "expected --noise beside it");
  const auto begin = std::chrono::steady_clock::now();
  Opened opened = open_input(options, options.sets);
  std::vector<Measurement> measurements = measurements_of(options, opened.model);
  const double end = options.time    ? *options.time
                     : options.steps ? static_cast<double>(*options.steps) * opened.scene.solver.time_step
                                     : opened.scene.duration;
  const FitIdentity identity =
      identity_of(with_known_files(opened.scene, opened.model.files), measurements, path_options(options, end));
  Graphics graphics;
  const std::unique_ptr<Simulator> simulator = simulator_of(options, opened, graphics);
  const TunedScene tuned = blaming_options([&] {
    std::vector<Parameter> parameters = parameters_of(opened.scene, options.free);
    for (const std::string& text : options.bounds) set_bounds(parameters, text);
    for (const std::string& text : options.priors) set_prior(parameters, text);
    return TunedScene(std::move(opened.scene), std::move(opened.model), std::move(parameters));
  });
  std::optional<FitProgressFile> record;
  if (!options.out.empty()) {
    make_fit_folder(options.out);
    record.emplace(options.out, identity);
  }
  const Experiment experiment(std::move(measurements), options.static_equilibrium, end, *simulator);
  FitOptions how;
  how.sweep = options.sweep;
  how.profile = options.profile;
  how.noise_known = !options.noise.empty();
  how.stop = interrupt_token();
  if (!options.quiet) how.say = [](const std::string& line) { std::cerr << "fascia: " << line << '\n'; };
  if (record) {
    how.earlier = record->read(tuned.parameters().size());
    how.keep = [&](const FitProgress& progress) { record->write(progress); };
    if (how.earlier && !options.quiet)
      std::cerr << "fascia: goes on after " << plural(static_cast<std::size_t>(how.earlier->simulations), "simulation")
                << " of an interrupted fit\n";
  }
  const FitResult result = blaming_options([&] { return fit(tuned, experiment, how); });
  if (result.interrupted) {
    if (record && !options.quiet)
      std::cerr << "fascia: interrupted; the same command goes on from " << record->file().string() << '\n';
    return exit_interrupted;
  }
  std::cout << fit_text(result, how.noise_known);
  if (record) {
    write_fit(options.out, result, {experiment, how.noise_known, options.command_line});
    record->remove();
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  if (!options.quiet)
    std::cerr << "fascia: " << (options.out.empty() ? "done" : options.out + "/report.html") << " after "
              << number(elapsed.count()) << " s\n";
  if (result.converged) return exit_done;
  std::cerr << "fascia: not converged: " << result.reason << '\n';
  return exit_failed;
}

}  // namespace

void add_fit(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<FitCommandOptions>();
  CLI::App& command = *program.add_subcommand(
      "fit", "finds the parameters with which a scene meets a measurement, and how sure they are");
  command
      .add_option("--measured", options->measured,
                  "curves with the columns of a history and their units, vertices index,x,y,z or a deformed surface; "
                  "with a weight of its squares")
      ->type_name("FILE[,WEIGHT]")
      ->allow_extra_args(false)
      ->required();
  command.add_option("--free", options->free, "scene values to find, as for --set")
      ->type_name("KEY,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->required();
  command.add_option("--bounds", options->bounds, "range of a free value")
      ->type_name("KEY=LOW:HIGH")
      ->allow_extra_args(false);
  command.add_option("--prior", options->priors, "what is known of a free value: mean and standard deviation")
      ->type_name("KEY=MEAN:SPREAD")
      ->allow_extra_args(false);
  command
      .add_option("--noise", options->noise,
                  "standard deviation of the measured values, a share of the largest one or an amount: 1%, 0.02N, "
                  "0.1mm; default: estimated from the residuals")
      ->type_name("NOISE")
      ->allow_extra_args(false);
  command.add_option("--columns", options->columns, "only these columns, without their units: reaction_y,probe")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      .add_option("--probe", options->probe,
                  "vertex of the columns probe_x_m, ...; default: that of the file, else the one farthest from the "
                  "supports")
      ->type_name("VERTEX");
  command.add_option("--sweep", options->sweep, "simulations spread over the ranges of the free values before the fit")
      ->type_name("N")
      ->check(at_least(0))
      ->capture_default_str();
  command.add_option("--profile", options->profile, "points of the misfit at either side of the minimum")
      ->type_name("N")
      ->check(at_least(0))
      ->capture_default_str();
  command.add_flag("--gpu", options->gpu,
                   "simulate on the GPU, by the scene's method: for meshes too large for the reference solver");
  command
      .add_option("--out", options->out, "folder for report.html, scene.json, fit.json and values.csv, made if missing")
      ->type_name("DIR");
  add_common(command, *options);
  add_examples(command,
               {"fascia fit block.json --static --measured pull.csv --free materials.default.young_modulus --out fit",
                "fascia fit liver.json --measured swing.csv --noise 1% --free "
                "materials.default.young_modulus,materials.default.damping"},
               "no minimum, or the measurement does not determine a value");
  command.callback([&invocation, options] {
    options->command_line = invocation.command_line;
    invocation.run = [options] { return run_fit(*options); };
  });
}

}  // namespace fascia
