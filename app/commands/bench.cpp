// fascia bench figures: measures and draws the four figures of the I3D 2019 paper, and the cost of colorings.
// fascia bench accuracy: error against iterations and time, of every method and acceleration, and against the
// continuum. fascia bench speed, static and skip: the cost of steps, of equilibria, and of features that are off.
// fascia bench dispatch: the cost of a dispatch.
// fascia bench contact: the cost of contact, and the iterations that it takes.
// fascia bench window: how the window feels.
// fascia bench fill and elements: the quality of tets that fill surfaces, linear or quadratic ones.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>
#include <sstream>

#include "app/bench/accuracy/accuracy.h"
#include "app/bench/accuracy/continuum.h"
#include "app/bench/bench.h"
#include "app/bench/contact.h"
#include "app/bench/dispatch.h"
#include "app/bench/fill/fill.h"
#include "app/bench/fill/filled_elements.h"
#include "app/bench/skip.h"
#include "app/bench/speed.h"
#include "app/bench/static_times.h"
#include "app/bench/window/window_bench.h"
#include "app/charts/gnuplot.h"
#include "app/cli/command_line.h"
#include "app/commands/command.h"
#include "base/error.h"
#include "base/suggest.h"
#include "sim/surface/surface_fill.h"

namespace fascia {
namespace {

// `measure` returns its findings, one line each.
int run_bench(const BenchOptions& options, const std::string& name,
              const std::function<std::vector<std::string>(Bench&)>& measure) {
  const auto start = std::chrono::steady_clock::now();
  try {
    Bench bench(options, name);
    bench.say(describe(bench.graphics));
    const std::vector<std::string> failures = measure(bench);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    bench.say(options.out + ", after " + std::to_string(std::lround(elapsed.count())) + " s");
    for (const std::string& failure : failures) std::cerr << "fascia: " << failure << '\n';
    return failures.empty() ? exit_done : exit_failed;
  } catch (const Interrupted&) {
    return exit_interrupted;
  }
}

int run_bench_with_charts(const BenchOptions& options, const std::string& name, const std::string& without_gnuplot,
                          const std::function<void(Bench&)>& measure) {
  return run_bench(options, name, [&](Bench& bench) {
    if (!bench.has_gnuplot) bench.say("no gnuplot: " + without_gnuplot + " only");
    measure(bench);
    if (!bench.has_gnuplot) throw Error(options.out, "no charts without gnuplot", kGnuplotPackage);
    return std::vector<std::string>();
  });
}

int run_figures(const BenchOptions& options) {
  return run_bench_with_charts(options, "figures", "tables and pictures", [](Bench& bench) {
    bench_scenes(bench);
    bench_stiff_beam(bench);
    bench_convergence(bench);
    bench_colorings(bench);
  });
}

int run_accuracy(const BenchOptions& options, bool fresh, const std::string& truth) {
  return run_bench_with_charts(options, "accuracy", "tables", [&](Bench& bench) {
    if (truth != "step") bench_continuum(bench, continuum_grid(options.quick));
    if (truth != "continuum") bench_accuracy(bench, accuracy_grid(options.quick), fresh);
  });
}

int run_speed(const BenchOptions& options, const std::string& against) {
  if (!against.empty()) read_speeds(against);  // an unreadable file is reported before an hour of work
  return run_bench(options, "speed", [&](Bench& bench) {
    const std::vector<SpeedRow> now = bench_speed(bench);
    return against.empty() ? std::vector<std::string>() : compare_with(bench, against, now);
  });
}

int run_skip(const BenchOptions& options) { return run_bench(options, "skip", bench_skip); }

void add_charts(CLI::App& command, BenchOptions& options) {
  std::string usual;
  for (const std::string& ending : options.charts) usual += (usual.empty() ? "" : ",") + ending.substr(1);
  std::vector<std::string> known;
  for (const std::string& ending : chart_endings()) known.push_back(ending.substr(1));
  command
      .add_option_function<std::string>(
          "--charts",
          [&options, known](const std::string& text) {
            options.charts.clear();
            std::istringstream parts(text);
            for (std::string part; std::getline(parts, part, ',');) {
              if (std::find(known.begin(), known.end(), part) == known.end())
                throw CLI::ValidationError("--charts", "is " + text + perhaps(part, known) +
                                                           "; expected one or more of " + join(known) +
                                                           ", with commas between them");
              options.charts.push_back("." + part);
            }
            if (options.charts.empty()) throw CLI::ValidationError("--charts", "is empty; expected " + join(known));
          },
          "files of the charts: svg, png, pdf")
      ->type_name("ENDINGS")
      ->default_str(usual);
}

int run_static(const BenchOptions& options) {
  return run_bench(options, "static", [](Bench& bench) {
    bench_static(bench);
    return std::vector<std::string>();
  });
}

int run_contact(const BenchOptions& options) {
  return run_bench(options, "contact", [](Bench& bench) {
    bench_contact(bench);
    return std::vector<std::string>();
  });
}

int run_fill(const BenchOptions& options) {
  const std::filesystem::path folder(options.out);
  std::error_code ignored;  // writing the table reports it
  std::filesystem::create_directories(folder, ignored);
  write_table(folder / "fill.csv", fill_table(options.quick));
  if (!options.quiet) std::cerr << "fascia: " << (folder / "fill.csv").string() << '\n';
  return exit_done;
}

void add_figures(CLI::App& bench, Invocation& invocation) {
  const auto options = std::make_shared<BenchOptions>();
  CLI::App& command = *bench.add_subcommand("figures", "the figures of the I3D 2019 paper, and the cost of colorings");
  command.add_option("--out", options->out, "folder for the files, made if missing")->type_name("DIR")->required();
  command.add_flag("--quick", options->quick,
                   "small meshes, few iterations: the same files in less time, the numbers worth little");
  add_charts(command, *options);
  add_size(command, options->width, options->height);
  add_graphics(command, *options);
  add_examples(command, {"fascia bench figures --quick --out figures"});
  command.callback([&invocation, options] { invocation.run = [options] { return run_figures(*options); }; });
}

void add_accuracy(CLI::App& bench, Invocation& invocation) {
  struct Options : BenchOptions {
    bool fresh = false;
    std::string truth = "both";
  };
  const auto options = std::make_shared<Options>();
  CLI::App& command =
      *bench.add_subcommand("accuracy",
                            "error against iterations and time: of every method against exact steps, of "
                            "elements, meshes and integrators against the continuum");
  command
      .add_option("--out", options->out, "folder for the files, made if missing; what it holds is not measured again")
      ->type_name("DIR")
      ->required();
  command.add_flag("--quick", options->quick, "three small cases, for a first look");
  command.add_flag("--fresh", options->fresh, "measure again what the folder holds");
  add_charts(command, *options);
  add_graphics(command, *options);
  add_choice(command, "--truth", options->truth, {"both", "step", "continuum"},
             "what errors are measured against: exact steps of the same mesh, or the continuum");
  add_examples(command, {"fascia bench accuracy --quick --out accuracy",
                         "fascia bench accuracy --truth continuum --out accuracy"});
  command.callback([&invocation, options] {
    invocation.run = [options] { return run_accuracy(*options, options->fresh, options->truth); };
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
  command.callback(
      [&invocation, options] { invocation.run = [options] { return run_speed(*options, options->against); }; });
}

void add_window(CLI::App& bench, Invocation& invocation) {
  const auto options = std::make_shared<WindowBenchOptions>();
  CLI::App& command = *bench.add_subcommand(
      "window", "the window under a hand, on a virtual screen (Xvfb, xdotool): real time, pictures, latency, freezes");
  command.add_option("--out", options->out, "folder for the table, made if missing")->type_name("DIR")->required();
  command.add_flag("--quick", options->quick, "one round, without busy programs beside the window");
  command.add_option("--against", options->against, "another build of fascia, measured in turn with this one")
      ->type_name("PROGRAM");
  command
      .add_option("--busy", options->busy, "programs that compute beside the window, one measurement for each number")
      ->type_name("N,...")
      ->delimiter(',')
      ->check(CLI::Range(0, 64))
      ->default_str("0,1,2,4; with --quick 0");
  add_size(command, options->width, options->height);
  add_graphics(command, *options);
  add_examples(command, {"fascia bench window --out window --against old/build/release/fascia"});
  command.callback([&invocation, options] {
    invocation.run = [options] {
      return run_bench(*options, "window", [&](Bench& bench_of_window) {
        bench_window(bench_of_window, *options);
        return std::vector<std::string>();
      });
    };
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
  command.callback([&invocation, options] { invocation.run = [options] { return run_skip(*options); }; });
}

void add_static(CLI::App& bench, Invocation& invocation) {
  const auto options = std::make_shared<BenchOptions>();
  CLI::App& command = *bench.add_subcommand(
      "static", "time and iterations to the static equilibrium of bent boxes, from 5,000 to a million tets");
  command.add_option("--out", options->out, "folder for the table, made if missing")->type_name("DIR")->required();
  command.add_flag("--quick", options->quick, "small meshes");
  add_graphics(command, *options);
  add_examples(command, {"fascia bench static --out static"});
  command.callback([&invocation, options] { invocation.run = [options] { return run_static(*options); }; });
}

void add_dispatch(CLI::App& bench, Invocation& invocation) {
  const auto options = std::make_shared<BenchOptions>();
  CLI::App& command = *bench.add_subcommand(
      "dispatch", "what a dispatch costs that waits for the one before it, over its work and its buffers");
  command.add_option("--out", options->out, "folder for the table, made if missing")->type_name("DIR")->required();
  command.add_flag("--quick", options->quick, "short chains, few repetitions");
  add_graphics(command, *options);
  add_examples(command, {"fascia bench dispatch --out dispatch"}, "a chain counted wrong");
  command.callback([&invocation, options] {
    invocation.run = [options] { return run_bench(*options, "dispatch", bench_dispatch); };
  });
}

void add_contact(CLI::App& bench, Invocation& invocation) {
  const auto options = std::make_shared<BenchOptions>();
  CLI::App& command = *bench.add_subcommand(
      "contact", "what contact with tools costs in a step, over points and meshes, and the iterations that it takes");
  command.add_option("--out", options->out, "folder for the tables, made if missing")->type_name("DIR")->required();
  command.add_flag("--quick", options->quick, "a small mesh, few repetitions");
  add_graphics(command, *options);
  add_examples(command, {"fascia bench contact --out contact"});
  command.callback([&invocation, options] { invocation.run = [options] { return run_contact(*options); }; });
}

void add_fill(CLI::App& bench, Invocation& invocation) {
  const auto options = std::make_shared<BenchOptions>();
  CLI::App& command = *bench.add_subcommand(
      "fill", "how well tets fill twenty closed surfaces: angles, volume, distance to the surface");
  command.add_option("--out", options->out, "folder for the table, made if missing")->type_name("DIR")->required();
  command.add_flag("--quick", options->quick, "a coarse resolution only");
  command.add_flag("--quiet", options->quiet, "print errors only");
  add_examples(command, {"fascia bench fill --out fill"});
  command.callback([&invocation, options] { invocation.run = [options] { return run_fill(*options); }; });
}

void add_elements(CLI::App& bench, Invocation& invocation) {
  struct Options : BenchOptions {
    std::vector<std::string> surfaces;
    std::vector<int> resolutions;
  };
  const auto options = std::make_shared<Options>();
  CLI::App& command = *bench.add_subcommand(
      "elements", "surfaces filled with linear tets and with fewer quadratic ones whose steps take as long");
  command.add_option("--out", options->out, "folder for the table, made if missing")->type_name("DIR")->required();
  command.add_option("surfaces", options->surfaces, "surfaces to fill; default: four shapes of fascia bench fill")
      ->type_name("FILE");
  command
      .add_option("--resolutions", options->resolutions,
                  "of the linear fill, the quadratic one and the one that both are compared with; default: the usual "
                  "one, one as fast, 1.75 times the usual one")
      ->type_name("N,N,N")
      ->delimiter(',')
      ->expected(3)
      ->check(CLI::Range(kFewestCells, kMostCells));
  command.add_flag("--quick", options->quick, "one Poisson's ratio");
  add_graphics(command, *options);
  add_examples(command, {"fascia bench elements --out elements kidney.obj"});
  command.callback([&invocation, options] {
    invocation.run = [options] {
      return run_bench(*options, "elements", [&](Bench& bench_of_fills) {
        bench_elements(bench_of_fills, {options->surfaces.begin(), options->surfaces.end()}, options->resolutions);
        return std::vector<std::string>();
      });
    };
  });
}

}  // namespace

void add_bench(CLI::App& program, Invocation& invocation) {
  CLI::App& bench = *program.add_subcommand("bench", "measurements as tables, charts and pictures");
  bench.require_subcommand(1);
  add_figures(bench, invocation);
  add_accuracy(bench, invocation);
  add_speed(bench, invocation);
  add_static(bench, invocation);
  add_dispatch(bench, invocation);
  add_skip(bench, invocation);
  add_contact(bench, invocation);
  add_window(bench, invocation);
  add_fill(bench, invocation);
  add_elements(bench, invocation);
}

}  // namespace fascia
